// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/track/piece_fit.h"

#include <gsl/gsl_blas.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_linalg.h>
#include <gsl/gsl_multifit_nlinear.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace inspector {

namespace {

using Vector = std::unique_ptr<gsl_vector, decltype(&gsl_vector_free)>;
using Matrix = std::unique_ptr<gsl_matrix, decltype(&gsl_matrix_free)>;
using Workspace = std::unique_ptr<gsl_multifit_nlinear_workspace, decltype(&gsl_multifit_nlinear_free)>;

Vector makeVector(size_t size) { return {gsl_vector_calloc(size), gsl_vector_free}; }
Matrix makeMatrix(size_t rows, size_t columns) { return {gsl_matrix_calloc(rows, columns), gsl_matrix_free}; }

constexpr size_t kStartNumbers = 4;
// Of the difference quotients of a start: m, m, m/s, m/s.
constexpr double kStartNotches[kStartNumbers] = {1e-7, 1e-7, 1e-6, 1e-6};
constexpr double kSmallestShift = 1e-6; // of the numbers, at which a fit ends

double &startNumber(StartGuess &start, size_t which) {
    double *const numbers[kStartNumbers]{&start.x, &start.y, &start.vx, &start.vy};
    return *numbers[which];
}

// L of covariance = L L^T; null if it isn't positive definite.
Matrix choleskyOf(const std::vector<std::vector<double>> &covariance) {
    const size_t n = covariance.size();
    Matrix lower = makeMatrix(std::max<size_t>(n, 1), std::max<size_t>(n, 1));
    for (size_t i = 0; i < n; ++i)
        for (size_t j = 0; j < n; ++j) gsl_matrix_set(lower.get(), i, j, covariance[i][j]);
    if (n > 0 && gsl_linalg_cholesky_decomp1(lower.get()) != GSL_SUCCESS) return {nullptr, gsl_matrix_free};
    return lower;
}

// The problem as GSL sees it. Numbers: the quantities, then the start, all in units in which they are about 1.
// Residuals: x and y of each point in units of the noise, then how far the quantities are from what was known, L^-1
// (value - mean).
class Problem {
public:
    Problem(const BallModel &model, const std::vector<FitQuantity> &quantities, const BoardKnowledge &before,
            const BoardGuess &board, const Piece &piece, double noise)
        : m_model(model)
        , m_quantities(quantities)
        , m_before(before)
        , m_lower(choleskyOf(before.covariance))
        , m_board(board)
        , m_piece(piece)
        , m_noise(noise) {}

    bool isReady() const { return m_lower != nullptr; }
    size_t shared() const { return m_quantities.size(); }
    size_t numbers() const { return shared() + kStartNumbers; }
    size_t pointResiduals() const { return 2 * (m_piece.last - m_piece.first + 1); }
    size_t residuals() const { return pointResiduals() + shared(); }

    Vector begin() {
        Vector x = makeVector(numbers());
        for (size_t i = 0; i < shared(); ++i) gsl_vector_set(x.get(), i, m_quantities[i].of(m_board) / unitOf(i));
        for (size_t k = 0; k < kStartNumbers; ++k)
            gsl_vector_set(x.get(), shared() + k, startNumber(m_piece.start, k) / unitOf(shared() + k));
        return x;
    }

    // Quantities beyond their bounds count as at them.
    BoardGuess boardAt(const gsl_vector *x) const {
        BoardGuess board = m_board;
        for (size_t i = 0; i < shared(); ++i)
            m_quantities[i].of(board) =
                std::clamp(gsl_vector_get(x, i) * unitOf(i), m_quantities[i].lower, m_quantities[i].upper);
        return board;
    }

    Piece pieceAt(const gsl_vector *x) const {
        Piece piece = m_piece;
        for (size_t k = 0; k < kStartNumbers; ++k)
            startNumber(piece.start, k) = gsl_vector_get(x, shared() + k) * unitOf(shared() + k);
        return piece;
    }

    void evaluate(const gsl_vector *x, gsl_vector *f) {
        run(boardAt(x), pieceAt(x), m_here);
        for (size_t i = 0; i < m_here.size(); ++i) gsl_vector_set(f, i, m_here[i]);
        const Vector apart = makeVector(std::max<size_t>(shared(), 1));
        for (size_t i = 0; i < shared(); ++i)
            gsl_vector_set(apart.get(), i, gsl_vector_get(x, i) * unitOf(i) - m_before.mean[i]);
        if (shared() > 0) gsl_blas_dtrsv(CblasLower, CblasNoTrans, CblasNonUnit, m_lower.get(), apart.get());
        for (size_t i = 0; i < shared(); ++i) gsl_vector_set(f, m_here.size() + i, gsl_vector_get(apart.get(), i));
    }

    void differentiate(const gsl_vector *x, gsl_matrix *jacobian) {
        gsl_matrix_set_zero(jacobian);
        const BoardGuess board = boardAt(x);
        const Piece piece = pieceAt(x);
        run(board, piece, m_here);
        for (size_t i = 0; i < shared(); ++i) {
            BoardGuess there = board;
            double &value = m_quantities[i].of(there);
            const double notch =
                value + m_quantities[i].notch > m_quantities[i].upper ? -m_quantities[i].notch : m_quantities[i].notch;
            value += notch;
            setColumn(there, piece, notch / unitOf(i), jacobian, i);
            setKnown(jacobian, i);
        }
        for (size_t k = 0; k < kStartNumbers; ++k) {
            Piece there = piece;
            startNumber(there.start, k) += kStartNotches[k];
            setColumn(board, there, kStartNotches[k] / unitOf(shared() + k), jacobian, shared() + k);
        }
    }

    double unitOf(size_t number) const {
        return number < shared() ? std::sqrt(m_before.covariance[number][number])
                                 : 1e3 * kStartNotches[number - shared()];
    }

    // Of points alone, at any numbers.
    const std::vector<double> &residualsAt(const gsl_vector *x) {
        run(boardAt(x), pieceAt(x), m_here);
        return m_here;
    }

private:
    void run(const BoardGuess &board, const Piece &piece, std::vector<double> &residuals) {
        m_model.run(board, piece.start, piece.first, piece.last, m_measured);
        residuals.clear();
        for (size_t i = 0; i < m_measured.size(); ++i) {
            const TrackPoint &seen = m_model.track().points[piece.first + i];
            residuals.push_back((m_measured[i].x - seen.x) / m_noise);
            residuals.push_back((m_measured[i].y - seen.y) / m_noise);
        }
    }

    void setColumn(const BoardGuess &board, const Piece &piece, double notch, gsl_matrix *jacobian, size_t column) {
        run(board, piece, m_there);
        for (size_t i = 0; i < m_here.size(); ++i)
            gsl_matrix_set(jacobian, i, column, (m_there[i] - m_here[i]) / notch);
    }

    void setKnown(gsl_matrix *jacobian, size_t column) {
        const Vector unit = makeVector(shared());
        gsl_vector_set(unit.get(), column, unitOf(column));
        gsl_blas_dtrsv(CblasLower, CblasNoTrans, CblasNonUnit, m_lower.get(), unit.get());
        for (size_t i = 0; i < shared(); ++i)
            gsl_matrix_set(jacobian, m_here.size() + i, column, gsl_vector_get(unit.get(), i));
    }

    const BallModel &m_model;
    const std::vector<FitQuantity> &m_quantities;
    const BoardKnowledge &m_before;
    Matrix m_lower;
    BoardGuess m_board;
    Piece m_piece;
    double m_noise;
    std::vector<TrackPoint> m_measured;
    std::vector<double> m_here, m_there;
};

int residualsForGsl(const gsl_vector *x, void *problem, gsl_vector *f) {
    static_cast<Problem *>(problem)->evaluate(x, f);
    return GSL_SUCCESS;
}

int slopesForGsl(const gsl_vector *x, void *problem, gsl_matrix *jacobian) {
    static_cast<Problem *>(problem)->differentiate(x, jacobian);
    return GSL_SUCCESS;
}

std::vector<std::vector<double>> rowsOf(const gsl_matrix *matrix, size_t count) {
    std::vector<std::vector<double>> rows(count, std::vector<double>(matrix->size2));
    for (size_t i = 0; i < count; ++i)
        for (size_t j = 0; j < matrix->size2; ++j) rows[i][j] = gsl_matrix_get(matrix, i, j);
    return rows;
}

BoardKnowledge knowledgeAfter(const Problem &problem, const std::vector<FitQuantity> &quantities, BoardGuess board,
                              const gsl_matrix *covariance) {
    const size_t n = problem.shared();
    BoardKnowledge after{{}, std::vector<std::vector<double>>(n, std::vector<double>(n))};
    for (size_t i = 0; i < n; ++i) {
        after.mean.push_back(quantities[i].of(board));
        for (size_t j = 0; j < n; ++j)
            after.covariance[i][j] = gsl_matrix_get(covariance, i, j) * problem.unitOf(i) * problem.unitOf(j);
    }
    return after;
}

} // namespace

double BoardKnowledge::deviation(size_t i) const { return std::sqrt(covariance[i][i]); }

BoardKnowledge weakKnowledge(const std::vector<FitQuantity> &quantities, const BoardGuess &board) {
    BoardKnowledge weak;
    const size_t n = quantities.size();
    weak.covariance.assign(n, std::vector<double>(n));
    for (size_t i = 0; i < n; ++i) {
        BoardGuess copy = board;
        weak.mean.push_back(quantities[i].of(copy));
        weak.covariance[i][i] = quantities[i].doubt * quantities[i].doubt;
    }
    return weak;
}

std::optional<PieceFit> fitPiece(const BallModel &model, const std::vector<FitQuantity> &quantities,
                                 const BoardKnowledge &before, const BoardGuess &board, const Piece &piece,
                                 double noise, int steps) {
    gsl_set_error_handler_off(); // its statuses are looked at
    Problem problem(model, quantities, before, board, piece, noise);
    if (!problem.isReady()) return std::nullopt;
    gsl_multifit_nlinear_fdf fdf{};
    fdf.f = residualsForGsl;
    fdf.df = slopesForGsl;
    fdf.n = problem.residuals();
    fdf.p = problem.numbers();
    fdf.params = &problem;
    const gsl_multifit_nlinear_parameters settings = gsl_multifit_nlinear_default_parameters();
    const Workspace workspace(gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &settings, fdf.n, fdf.p),
                              gsl_multifit_nlinear_free);
    const Vector x = problem.begin();
    if (!workspace || gsl_multifit_nlinear_init(x.get(), &fdf, workspace.get()) != GSL_SUCCESS) return std::nullopt;
    int info = 0; // that it may come to no end within the steps is seen from the residuals
    gsl_multifit_nlinear_driver(size_t(steps), kSmallestShift, 1e-6, 1e-6, nullptr, nullptr, &info, workspace.get());

    const gsl_vector *position = gsl_multifit_nlinear_position(workspace.get());
    const gsl_vector *residual = gsl_multifit_nlinear_residual(workspace.get());
    PieceFit fit{problem.boardAt(position), problem.pieceAt(position), {}, {}, {}, {}, {}};
    const gsl_matrix *jacobian = gsl_multifit_nlinear_jac(workspace.get());
    const Matrix covariance = makeMatrix(fdf.p, fdf.p);
    gsl_multifit_nlinear_covar(jacobian, 0.0, covariance.get());
    fit.knowledge = knowledgeAfter(problem, quantities, fit.board, covariance.get());
    for (size_t i = 0; i < fdf.p; ++i) fit.numbers.push_back(gsl_vector_get(position, i));
    fit.covariance = rowsOf(covariance.get(), fdf.p);
    fit.slopes = rowsOf(jacobian, problem.pointResiduals());
    for (size_t i = 0; i < problem.pointResiduals(); ++i) fit.residuals.push_back(gsl_vector_get(residual, i) * noise);
    return fit;
}

// Along each axis of the fit's uncertainty the ball is moved by a deviation, and the places it comes to are compared
// with those of the slopes.
bool isPredicted(const BallModel &model, const std::vector<FitQuantity> &quantities, const BoardKnowledge &knowledge,
                 const PieceFit &before, const PieceFit &after, double noise) {
    constexpr double kFarthest = 5.0; // in units of the noise: a ball that is known no better isn't known
    constexpr double kBend = 0.5;     // of the move, that may be out of proportion
    constexpr double kSmall = 0.5;    // in units of the noise: moves that don't matter
    const Matrix lower = choleskyOf(before.covariance);
    if (!lower) return false;
    Piece piece = after.piece;
    piece.start = before.piece.start;
    Problem problem(model, quantities, knowledge, before.board, piece, noise);
    const size_t count = before.numbers.size();
    const Vector x = makeVector(count);
    const auto place = [&](std::optional<size_t> axis) {
        for (size_t i = 0; i < count; ++i)
            gsl_vector_set(x.get(), i,
                           before.numbers[i] + (axis && i >= *axis ? gsl_matrix_get(lower.get(), i, *axis) : 0.0));
        return problem.residualsAt(x.get());
    };
    const std::vector<double> here = place(std::nullopt);
    for (size_t axis = 0; axis < count; ++axis) {
        const std::vector<double> there = place(axis);
        for (size_t r = before.residuals.size(); r < here.size(); ++r) {
            double expected = 0.0;
            for (size_t i = axis; i < count; ++i) expected += after.slopes[r][i] * gsl_matrix_get(lower.get(), i, axis);
            const double moved = there[r] - here[r];
            if (std::abs(moved) > kFarthest || std::abs(expected) > kFarthest) return false;
            if (std::abs(moved - expected) > std::max(kSmall, kBend * std::abs(moved))) return false;
        }
    }
    return true;
}

} // namespace inspector
