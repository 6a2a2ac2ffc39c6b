// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trade/trade_svg.h"

#include "core/setup/tables.h"
#include "core/trade/trade_answer.h"
#include "core/trade/trade_table.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace inspector {

namespace {

constexpr double kWidth = 900.0;
constexpr double kHeight = 560.0;
constexpr double kLeft = 90.0;
constexpr double kRight = 720.0;
constexpr double kTop = 50.0;
constexpr double kBottom = 490.0;

QByteArray number(double value) { return QByteArray::number(value, 'f', 1); }

QByteArray text(double x, double y, const char *look, const QString &words) {
    return "<text x=\"" + number(x) + "\" y=\"" + number(y) + "\" " + look + ">" + words.toHtmlEscaped().toUtf8() +
           "</text>\n";
}

QByteArray line(double x0, double y0, double x1, double y1, const char *look) {
    return "<line x1=\"" + number(x0) + "\" y1=\"" + number(y0) + "\" x2=\"" + number(x1) + "\" y2=\"" + number(y1) +
           "\" " + look + "/>\n";
}

// Whole decades around all values, and where they lie on the page.
class LogAxis {
public:
    LogAxis(const std::vector<double> &values, double begin, double end)
        : m_begin(begin)
        , m_end(end) {
        if (values.empty()) return;
        const auto [least, most] = std::minmax_element(values.begin(), values.end());
        m_low = std::floor(std::log10(*least));
        m_high = std::max(m_low + 1.0, std::ceil(std::log10(*most)));
    }
    double at(double value) const {
        return m_begin + (std::log10(value) - m_low) / (m_high - m_low) * (m_end - m_begin);
    }
    int low() const { return int(m_low); }
    int high() const { return int(m_high); }

private:
    double m_begin, m_end;
    double m_low = 0.0;
    double m_high = 1.0;
};

double cost(const TradePoint &point) { return std::max(point.cost.perSecond * 1e6, 1e-6); }
double error(const TradePoint &point) { return std::max(point.error.positionLargest, kSmallestDrawnError); }

QString decade(int exponent) {
    if (std::abs(exponent) <= 3) return QString::number(std::pow(10.0, exponent));
    return QStringLiteral("1e%1").arg(exponent);
}

QByteArray grid(const LogAxis &x, const LogAxis &y) {
    QByteArray svg;
    const char *const faint = "stroke=\"#ddd\"";
    for (int i = x.low(); i <= x.high(); ++i) {
        const double place = x.at(std::pow(10.0, i));
        svg += line(place, kTop, place, kBottom, faint);
        svg += text(place, kBottom + 20.0, "text-anchor=\"middle\"", decade(i));
    }
    const int every = y.high() - y.low() > 9 ? 2 : 1;
    for (int i = y.low(); i <= y.high(); i += every) {
        const double place = y.at(std::pow(10.0, i));
        svg += line(kLeft, place, kRight, place, faint);
        svg += text(kLeft - 8.0, place + 4.0, "text-anchor=\"end\"", decade(i));
    }
    svg += line(kLeft, kBottom, kRight, kBottom, "stroke=\"black\"") +
           line(kLeft, kTop, kLeft, kBottom, "stroke=\"black\"");
    svg += text(0.5 * (kLeft + kRight), kBottom + 48.0, "text-anchor=\"middle\"",
                QStringLiteral("CPU time of a simulated second [µs]"));
    svg += text(-0.5 * (kTop + kBottom), 26.0, "text-anchor=\"middle\" transform=\"rotate(-90)\"",
                QStringLiteral("largest position error [radii]"));
    return svg;
}

class Page {
public:
    explicit Page(std::vector<TradePoint> points)
        : m_points(std::move(points))
        , m_x(valuesOf(cost), kLeft, kRight)
        , m_y(valuesOf(error), kBottom, kTop) {}

    QByteArray draw() const {
        QByteArray svg = grid(m_x, m_y) + front();
        std::vector<QByteArray> names;
        for (const TradePoint &point : m_points)
            if (std::find(names.begin(), names.end(), point.stepper) == names.end()) names.push_back(point.stepper);
        for (size_t i = 0; i < names.size(); ++i) svg += curve(names[i], i);
        svg += line(kRight + 20.0, kTop + 26.0 * double(names.size()) + 10.0, kRight + 50.0,
                    kTop + 26.0 * double(names.size()) + 10.0, kFrontLook);
        svg += text(kRight + 58.0, kTop + 26.0 * double(names.size()) + 14.0, "", QStringLiteral("best for its cost"));
        return svg;
    }

private:
    static constexpr const char *kFrontLook = "fill=\"none\" stroke=\"#f2d26b\" stroke-width=\"9\" "
                                              "stroke-linejoin=\"round\" stroke-linecap=\"round\"";

    std::vector<double> valuesOf(double (*value)(const TradePoint &)) const {
        std::vector<double> values;
        for (const TradePoint &point : m_points) values.push_back(value(point));
        return values;
    }

    QByteArray place(const TradePoint &point) const {
        return number(m_x.at(cost(point))) + "," + number(m_y.at(error(point)));
    }

    QByteArray front() const {
        QByteArray places;
        for (const size_t i : paretoFront(m_points)) places += place(m_points[i]) + ' ';
        return "<polyline points=\"" + places + "\" " + kFrontLook + "/>\n";
    }

    QByteArray curve(const QByteArray &stepper, size_t number_) const {
        const QByteArray colour = curveColour(number_);
        QByteArray places;
        QByteArray marks;
        for (const TradePoint &point : m_points) {
            if (point.stepper != stepper) continue;
            places += place(point) + ' ';
            marks += "<circle cx=\"" + number(m_x.at(cost(point))) + "\" cy=\"" + number(m_y.at(error(point))) +
                     "\" r=\"4\" fill=\"" + colour + "\"><title>" + point.stepper + ", " +
                     stepSizeText(point.dt).toUtf8() + "</title></circle>\n";
        }
        const double row = kTop + 26.0 * double(number_) + 10.0;
        const QByteArray look = "stroke=\"" + colour + "\" stroke-width=\"2\" fill=\"none\"";
        return "<polyline points=\"" + places + "\" " + look + "/>\n" + marks +
               line(kRight + 20.0, row, kRight + 50.0, row, look.constData()) +
               text(kRight + 58.0, row + 4.0, "", QString::fromUtf8(stepper));
    }

    std::vector<TradePoint> m_points;
    LogAxis m_x;
    LogAxis m_y;
};

} // namespace

const char *curveColour(size_t place) {
    // Distinct for colour-blind eyes, too (Okabe and Ito).
    static constexpr std::array<const char *, 7> kColours{"#d55e00", "#0072b2", "#009e73", "#cc79a7",
                                                          "#56b4e9", "#000000", "#e69f00"};
    return kColours[place % kColours.size()];
}

QByteArray tradeSvg(const TradePlan &plan, const TradeResult &result, uint32_t model) {
    const QString title = QStringLiteral("%1 model, schedule %2, errors up to %3 s")
                              .arg(modelName(model), plan.schedule.name)
                              .arg(result.spans[model].compared, 0, 'f', 2);
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + number(kWidth) + ' ' + number(kHeight) +
           "\" font-family=\"sans-serif\" font-size=\"13\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n" +
           text(kLeft, 28.0, "font-size=\"15\"", title) + Page(result.valid(model)).draw() + "</svg>\n";
}

} // namespace inspector
