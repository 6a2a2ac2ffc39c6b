// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/track/segment_fit.h"

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
/// Finite-difference increments of a start: m, m, m/s, m/s.
constexpr double kStartIncrements[kStartNumbers] = {1e-7, 1e-7, 1e-6, 1e-6};
/// Prior standard deviations of a start that was read off a track or found with fewer points: m, m, m/s, m/s. A wall
/// absorbs a push towards it, so the points of a ball that leans on a wall may not determine its start.
constexpr double kStartDeviations[kStartNumbers] = {1e-3, 1e-3, 2e-2, 2e-2};
constexpr double kSmallestDecrement =
    1e-2; ///< decrease of the sum of squares, in units of the noise, at which a fit has converged
constexpr double kNonlinearity =
    1e-3;                     ///< sum of squares, in units of the noise, by which the linear prediction may be off
constexpr int kMostTries = 5; ///< trial steps with one Jacobian

double &startNumber(BallStart &start, size_t which) {
    double *const numbers[kStartNumbers]{&start.x, &start.y, &start.vx, &start.vy};
    return *numbers[which];
}

/// L of covariance = L L^T; null if the covariance isn't positive definite.
Matrix choleskyOf(const std::vector<std::vector<double>> &covariance) {
    const size_t n = covariance.size();
    Matrix lower = makeMatrix(std::max<size_t>(n, 1), std::max<size_t>(n, 1));
    for (size_t i = 0; i < n; ++i)
        for (size_t j = 0; j < n; ++j) gsl_matrix_set(lower.get(), i, j, covariance[i][j]);
    if (n > 0 && gsl_linalg_cholesky_decomp1(lower.get()) != GSL_SUCCESS) return {nullptr, gsl_matrix_free};
    return lower;
}

/// The problem as GSL sees it. Unknowns: the quantities, then the start, all scaled to be about 1. Residuals: x and y
/// of each point in units of the noise, then the deviation from the prior, L^-1 (value - mean).
class Problem {
public:
    Problem(const BallModel &model, const std::vector<FitQuantity> &quantities, const BoardEstimate &before,
            const BoardParameters &board, const TrackSegment &segment, double noise)
        : m_model(model)
        , m_quantities(quantities)
        , m_before(before)
        , m_lower(choleskyOf(before.covariance))
        , m_board(board)
        , m_segment(segment)
        , m_noise(noise) {
        if (m_segment.increments.size() == numbers()) return;
        m_segment.increments.clear();
        for (size_t i = 0; i < numbers(); ++i) m_segment.increments.push_back(usualIncrement(i));
    }

    bool isReady() const { return m_lower != nullptr; }
    size_t quantityCount() const { return m_quantities.size(); }
    size_t numbers() const { return quantityCount() + kStartNumbers; }
    size_t pointResiduals() const { return 2 * (m_segment.last - m_segment.first + 1); }
    size_t residuals() const { return pointResiduals() + numbers(); }

    Vector begin() {
        Vector x = makeVector(numbers());
        for (size_t i = 0; i < quantityCount(); ++i)
            gsl_vector_set(x.get(), i, m_quantities[i].of(m_board) / unitOf(i));
        for (size_t k = 0; k < kStartNumbers; ++k)
            gsl_vector_set(x.get(), quantityCount() + k, startNumber(m_segment.start, k) / unitOf(quantityCount() + k));
        return x;
    }

    /// Quantities are clamped to their bounds.
    BoardParameters boardAt(const gsl_vector *x) const {
        BoardParameters board = m_board;
        for (size_t i = 0; i < quantityCount(); ++i)
            m_quantities[i].of(board) =
                std::clamp(gsl_vector_get(x, i) * unitOf(i), m_quantities[i].lower, m_quantities[i].upper);
        return board;
    }

    TrackSegment segmentAt(const gsl_vector *x) const {
        TrackSegment segment = m_segment;
        for (size_t k = 0; k < kStartNumbers; ++k)
            startNumber(segment.start, k) = gsl_vector_get(x, quantityCount() + k) * unitOf(quantityCount() + k);
        return segment;
    }

    /// False after too many trials with one Jacobian, which ends the fit: none of them was an improvement.
    bool evaluate(const gsl_vector *x, gsl_vector *f) {
        if (m_tries++ == kMostTries) return false;
        run(boardAt(x), segmentAt(x), m_residuals);
        for (size_t i = 0; i < m_residuals.size(); ++i) gsl_vector_set(f, i, m_residuals[i]);
        const Vector apart = makeVector(std::max<size_t>(quantityCount(), 1));
        for (size_t i = 0; i < quantityCount(); ++i)
            gsl_vector_set(apart.get(), i, gsl_vector_get(x, i) * unitOf(i) - m_before.mean[i]);
        if (quantityCount() > 0) gsl_blas_dtrsv(CblasLower, CblasNoTrans, CblasNonUnit, m_lower.get(), apart.get());
        for (size_t i = 0; i < quantityCount(); ++i)
            gsl_vector_set(f, m_residuals.size() + i, gsl_vector_get(apart.get(), i));
        for (size_t k = 0; k < kStartNumbers; ++k)
            gsl_vector_set(f, m_residuals.size() + quantityCount() + k,
                           (gsl_vector_get(x, quantityCount() + k) * unitOf(quantityCount() + k) -
                            startNumber(m_segment.start, k)) /
                               kStartDeviations[k]);
        return true;
    }

    /// GSL asks for the Jacobian at the point of its last residual evaluation.
    void differentiate(const gsl_vector *x, gsl_matrix *jacobian) {
        m_tries = 0;
        if (isLinearAt(x)) {
            gsl_matrix_memcpy(jacobian, m_jacobian.get());
            return;
        }
        gsl_matrix_set_zero(jacobian);
        const BoardParameters board = boardAt(x);
        const TrackSegment segment = segmentAt(x);
        for (size_t i = 0; i < quantityCount(); ++i) {
            setColumn(board, segment, jacobian, i);
            setPriorRows(jacobian, i);
        }
        for (size_t k = 0; k < kStartNumbers; ++k) {
            setColumn(board, segment, jacobian, quantityCount() + k);
            gsl_matrix_set(jacobian, m_residuals.size() + quantityCount() + k, quantityCount() + k,
                           unitOf(quantityCount() + k) / kStartDeviations[k]);
        }
        keepJacobian(x, jacobian);
    }

    double unitOf(size_t number) const {
        return number < quantityCount() ? std::sqrt(m_before.covariance[number][number])
                                        : 1e3 * kStartIncrements[number - quantityCount()];
    }

    /// The points' residuals (without the prior's) at these numbers.
    std::vector<double> residualsAt(const std::vector<double> &numbers) {
        const Vector x = makeVector(numbers.size());
        for (size_t i = 0; i < numbers.size(); ++i) gsl_vector_set(x.get(), i, numbers[i]);
        run(boardAt(x.get()), segmentAt(x.get()), m_residuals);
        return m_residuals;
    }

private:
    void run(const BoardParameters &board, const TrackSegment &segment, std::vector<double> &residuals) {
        m_model.run(board, segment.start, segment.first, segment.last, m_measured);
        residuals.clear();
        for (size_t i = 0; i < m_measured.size(); ++i) {
            const TrackPoint &seen = m_model.track().points[segment.first + i];
            residuals.push_back((m_measured[i].x - seen.x) / m_noise);
            residuals.push_back((m_measured[i].y - seen.y) / m_noise);
        }
    }

    void keepJacobian(const gsl_vector *x, const gsl_matrix *jacobian) {
        m_jacobian = makeMatrix(jacobian->size1, jacobian->size2);
        gsl_matrix_memcpy(m_jacobian.get(), jacobian);
        m_jacobianAt = makeVector(x->size);
        gsl_vector_memcpy(m_jacobianAt.get(), x);
        m_jacobianResiduals = m_residuals;
    }

    /// Whether the last Jacobian predicts the residuals at x; it is then still valid and isn't computed again.
    bool isLinearAt(const gsl_vector *x) const {
        if (!m_jacobian) return false;
        const Vector shift = makeVector(x->size);
        gsl_vector_memcpy(shift.get(), x);
        gsl_vector_sub(shift.get(), m_jacobianAt.get());
        const Vector expected = makeVector(m_jacobian->size1);
        gsl_blas_dgemv(CblasNoTrans, 1.0, m_jacobian.get(), shift.get(), 0.0, expected.get());
        double squares = 0.0;
        for (size_t i = 0; i < m_residuals.size(); ++i) {
            const double bend = m_residuals[i] - m_jacobianResiduals[i] - gsl_vector_get(expected.get(), i);
            squares += bend * bend;
        }
        return squares < kNonlinearity;
    }

    /// Column of the Jacobian by a finite difference. A good increment moves the ball by much less than the noise, and
    /// by much more than the jumps that occur when a ball that leans on a wall bounces once more.
    void setColumn(const BoardParameters &board, const TrackSegment &segment, gsl_matrix *jacobian, size_t column) {
        constexpr double kWanted = 0.05; // in units of the noise
        constexpr double kTooFar = 0.5;
        double &increment = m_segment.increments[column];
        double moved = 0.0;
        for (int attempt = 0; attempt < 2; ++attempt) {
            const double taken = runShifted(board, segment, column, increment);
            moved = 0.0;
            for (size_t i = 0; i < m_residuals.size(); ++i) {
                const double difference = m_shiftedResiduals[i] - m_residuals[i];
                moved = std::max(moved, std::abs(difference));
                gsl_matrix_set(jacobian, i, column, difference / (taken / unitOf(column)));
            }
            const double usual = usualIncrement(column);
            increment = std::clamp(increment * kWanted / std::max(moved, 1e-9), 1e-3 * usual, 10.0 * usual);
            if (moved < kTooFar) return;
        }
    }

    /// Runs with one number changed; returns the increment, which is negative at the upper bound.
    double runShifted(BoardParameters board, TrackSegment segment, size_t column, double increment) {
        if (column >= quantityCount()) {
            startNumber(segment.start, column - quantityCount()) += increment;
        } else {
            double &value = m_quantities[column].of(board);
            if (value + increment > m_quantities[column].upper) increment = -increment;
            value += increment;
        }
        run(board, segment, m_shiftedResiduals);
        return increment;
    }

    double usualIncrement(size_t number) const {
        return number < quantityCount() ? m_quantities[number].increment : kStartIncrements[number - quantityCount()];
    }

    void setPriorRows(gsl_matrix *jacobian, size_t column) {
        const Vector unit = makeVector(quantityCount());
        gsl_vector_set(unit.get(), column, unitOf(column));
        gsl_blas_dtrsv(CblasLower, CblasNoTrans, CblasNonUnit, m_lower.get(), unit.get());
        for (size_t i = 0; i < quantityCount(); ++i)
            gsl_matrix_set(jacobian, m_residuals.size() + i, column, gsl_vector_get(unit.get(), i));
    }

    const BallModel &m_model;
    const std::vector<FitQuantity> &m_quantities;
    const BoardEstimate &m_before;
    Matrix m_lower;
    BoardParameters m_board;
    TrackSegment m_segment;
    double m_noise;
    std::vector<TrackPoint> m_measured;
    std::vector<double> m_residuals, m_shiftedResiduals;
    int m_tries = 0;
    Matrix m_jacobian{nullptr, gsl_matrix_free}; ///< the last one, and where it was computed
    Vector m_jacobianAt{nullptr, gsl_vector_free};
    std::vector<double> m_jacobianResiduals; ///< residuals there
};

int residualsForGsl(const gsl_vector *x, void *problem, gsl_vector *f) {
    return static_cast<Problem *>(problem)->evaluate(x, f) ? GSL_SUCCESS : GSL_EMAXITER;
}

int jacobianForGsl(const gsl_vector *x, void *problem, gsl_matrix *jacobian) {
    static_cast<Problem *>(problem)->differentiate(x, jacobian);
    return GSL_SUCCESS;
}

/// R of J = Q R; the covariance is R^-1 R^-T.
Matrix triangularFactorOf(const gsl_matrix *jacobian) {
    const size_t count = jacobian->size2;
    const Matrix both = makeMatrix(jacobian->size1, count);
    gsl_matrix_memcpy(both.get(), jacobian);
    const Vector tau = makeVector(count);
    gsl_linalg_QR_decomp(both.get(), tau.get());
    Matrix triangularFactor = makeMatrix(count, count);
    for (size_t i = 0; i < count; ++i)
        for (size_t j = i; j < count; ++j)
            gsl_matrix_set(triangularFactor.get(), i, j, gsl_matrix_get(both.get(), i, j));
    return triangularFactor;
}

/// The decrease of the sum of squares in a Gauss-Newton step: |R^-T g|^2 with g = J^T f.
double decrement(const gsl_multifit_nlinear_workspace *workspace) {
    const gsl_matrix *jacobian = gsl_multifit_nlinear_jac(workspace);
    const Vector gradient = makeVector(jacobian->size2);
    gsl_blas_dgemv(CblasTrans, 1.0, jacobian, gsl_multifit_nlinear_residual(workspace), 0.0, gradient.get());
    gsl_blas_dtrsv(CblasUpper, CblasTrans, CblasNonUnit, triangularFactorOf(jacobian).get(), gradient.get());
    double squares = 0.0;
    gsl_blas_ddot(gradient.get(), gradient.get(), &squares);
    return squares;
}

Matrix covarianceOf(const gsl_matrix *triangularFactor) {
    const size_t count = triangularFactor->size1;
    const Matrix inverse = makeMatrix(count, count);
    gsl_matrix_set_identity(inverse.get());
    gsl_blas_dtrsm(CblasLeft, CblasUpper, CblasNoTrans, CblasNonUnit, 1.0, triangularFactor, inverse.get());
    Matrix covariance = makeMatrix(count, count);
    gsl_blas_dgemm(CblasNoTrans, CblasTrans, 1.0, inverse.get(), inverse.get(), 0.0, covariance.get());
    return covariance;
}

std::vector<std::vector<double>> rowsOf(const gsl_matrix *matrix, size_t count) {
    std::vector<std::vector<double>> rows(count, std::vector<double>(matrix->size2));
    for (size_t i = 0; i < count; ++i)
        for (size_t j = 0; j < matrix->size2; ++j) rows[i][j] = gsl_matrix_get(matrix, i, j);
    return rows;
}

BoardEstimate estimateAfter(const Problem &problem, const std::vector<FitQuantity> &quantities, BoardParameters board,
                            const gsl_matrix *covariance) {
    const size_t n = problem.quantityCount();
    BoardEstimate after{{}, std::vector<std::vector<double>>(n, std::vector<double>(n))};
    for (size_t i = 0; i < n; ++i) {
        after.mean.push_back(quantities[i].of(board));
        for (size_t j = 0; j < n; ++j)
            after.covariance[i][j] = gsl_matrix_get(covariance, i, j) * problem.unitOf(i) * problem.unitOf(j);
    }
    return after;
}

} // namespace

double BoardEstimate::deviation(size_t i) const { return std::sqrt(covariance[i][i]); }

BoardEstimate weakPrior(const std::vector<FitQuantity> &quantities, const BoardParameters &board) {
    BoardEstimate weak;
    const size_t n = quantities.size();
    weak.covariance.assign(n, std::vector<double>(n));
    for (size_t i = 0; i < n; ++i) {
        BoardParameters copy = board;
        weak.mean.push_back(quantities[i].of(copy));
        weak.covariance[i][i] = quantities[i].priorDeviation * quantities[i].priorDeviation;
    }
    return weak;
}

std::optional<SegmentFit> fitSegment(const BallModel &model, const std::vector<FitQuantity> &quantities,
                                     const BoardEstimate &before, const BoardParameters &board,
                                     const TrackSegment &segment, double noise, int steps) {
    gsl_set_error_handler_off(); // statuses are checked instead
    Problem problem(model, quantities, before, board, segment, noise);
    if (!problem.isReady()) return std::nullopt;
    gsl_multifit_nlinear_fdf fdf{};
    fdf.f = residualsForGsl;
    fdf.df = jacobianForGsl;
    fdf.n = problem.residuals();
    fdf.p = problem.numbers();
    fdf.params = &problem;
    const gsl_multifit_nlinear_parameters settings = gsl_multifit_nlinear_default_parameters();
    const Workspace workspace(gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &settings, fdf.n, fdf.p),
                              gsl_multifit_nlinear_free);
    const Vector x = problem.begin();
    if (!workspace || gsl_multifit_nlinear_init(x.get(), &fdf, workspace.get()) != GSL_SUCCESS) return std::nullopt;
    // Whether it has converged is judged from the residuals.
    for (int step = 0; step < steps && decrement(workspace.get()) > kSmallestDecrement; ++step)
        if (gsl_multifit_nlinear_iterate(workspace.get()) != GSL_SUCCESS) break;

    const gsl_vector *position = gsl_multifit_nlinear_position(workspace.get());
    const gsl_vector *residual = gsl_multifit_nlinear_residual(workspace.get());
    SegmentFit fit{problem.boardAt(position), problem.segmentAt(position), {}, {}, {}, {}, {}};
    const gsl_matrix *jacobian = gsl_multifit_nlinear_jac(workspace.get());
    const Matrix triangularFactor = triangularFactorOf(jacobian);
    fit.estimate = estimateAfter(problem, quantities, fit.board, covarianceOf(triangularFactor.get()).get());
    for (size_t i = 0; i < fdf.p; ++i) fit.numbers.push_back(gsl_vector_get(position, i));
    fit.triangularFactor = rowsOf(triangularFactor.get(), fdf.p);
    fit.jacobian = rowsOf(jacobian, problem.pointResiduals());
    for (size_t i = 0; i < problem.pointResiduals(); ++i) fit.residuals.push_back(gsl_vector_get(residual, i) * noise);
    return fit;
}

namespace {

/// Shifts of the unknowns by one standard deviation along the principal axes of their uncertainty, ordered by how far
/// they move the ball in the residuals from `first` on. In units of the noise, each with the linearly predicted
/// residuals.
struct Shift {
    std::vector<double> numbers;
    std::vector<double> expected;
    double largest = 0.0;
};

std::vector<Shift> shiftsOf(const SegmentFit &before, const SegmentFit &after) {
    const size_t first = before.residuals.size();
    const size_t added = after.residuals.size() - first;
    const size_t count = before.numbers.size();
    const Matrix triangularFactor = makeMatrix(count, count);
    const Matrix jacobian = makeMatrix(std::max(added, count), count); // GSL wants no fewer rows than columns
    for (size_t i = 0; i < count; ++i) {
        for (size_t j = i; j < count; ++j) gsl_matrix_set(triangularFactor.get(), i, j, before.triangularFactor[i][j]);
        for (size_t r = 0; r < added; ++r) gsl_matrix_set(jacobian.get(), r, i, after.jacobian[first + r][i]);
    }
    // J R^-1 = U S V^T: the axes are the columns of R^-1 V, and move the residuals by those of U S.
    gsl_blas_dtrsm(CblasRight, CblasUpper, CblasNoTrans, CblasNonUnit, 1.0, triangularFactor.get(), jacobian.get());
    const Matrix turned = makeMatrix(count, count);
    const Vector sizes = makeVector(count);
    const Vector work = makeVector(count);
    gsl_linalg_SV_decomp(jacobian.get(), turned.get(), sizes.get(), work.get());
    gsl_blas_dtrsm(CblasLeft, CblasUpper, CblasNoTrans, CblasNonUnit, 1.0, triangularFactor.get(), turned.get());
    std::vector<Shift> shifts(count);
    for (size_t k = 0; k < count; ++k) {
        Shift &shift = shifts[k];
        for (size_t i = 0; i < count; ++i) shift.numbers.push_back(gsl_matrix_get(turned.get(), i, k));
        for (size_t r = 0; r < added; ++r) {
            shift.expected.push_back(gsl_matrix_get(jacobian.get(), r, k) * gsl_vector_get(sizes.get(), k));
            shift.largest = std::max(shift.largest, std::abs(shift.expected.back()));
        }
    }
    return shifts;
}

} // namespace

bool isPredicted(const BallModel &model, const std::vector<FitQuantity> &quantities, const BoardEstimate &estimate,
                 const SegmentFit &before, const SegmentFit &after, double noise) {
    constexpr double kFarthest = 5.0;   // in units of the noise: beyond this the position isn't known
    constexpr double kBend = 0.5;       // share of a move by which it may be nonlinear
    constexpr double kSmall = 0.5;      // in units of the noise: negligible moves
    constexpr size_t kFewestShifts = 2; // always tried, however small
    const std::vector<Shift> shifts = shiftsOf(before, after);
    TrackSegment segment = after.segment;
    segment.start = before.segment.start;
    Problem problem(model, quantities, estimate, before.board, segment, noise);
    const size_t first = before.residuals.size();
    const std::vector<double> here = problem.residualsAt(before.numbers);
    for (size_t k = 0; k < shifts.size(); ++k) {
        const Shift &shift = shifts[k];
        if (shift.largest > kFarthest) return false;
        if (k >= kFewestShifts && shift.largest < kSmall) continue;
        std::vector<double> numbers = before.numbers;
        for (size_t i = 0; i < numbers.size(); ++i) numbers[i] += shift.numbers[i];
        const std::vector<double> there = problem.residualsAt(numbers);
        for (size_t r = first; r < here.size(); ++r) {
            const double moved = there[r] - here[r];
            if (std::abs(moved) > kFarthest) return false;
            if (std::abs(moved - shift.expected[r - first]) > std::max(kSmall, kBend * std::abs(moved))) return false;
        }
    }
    return true;
}

} // namespace inspector
