// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trade/trade_svg.h"

#include <algorithm>
#include <cmath>

namespace inspector {

namespace {

constexpr double kWidth = 960.0;
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

/// Whole decades around all values, mapped to the page.
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

QString decade(int exponent) {
    if (std::abs(exponent) <= 3) return QString::number(std::pow(10.0, exponent));
    return QStringLiteral("1e%1").arg(exponent);
}

class Page {
public:
    explicit Page(const ChartDescription &chart)
        : m_chart(chart)
        , m_x(costs(), kLeft, kRight)
        , m_y(errors(), kBottom, kTop) {}

    QByteArray draw() {
        QByteArray svg = text(kLeft, 28.0, "font-size=\"15\"", m_chart.title) + bandArea() + grid() + front();
        for (const ChartCurve &curve : m_chart.curves) svg += draw(curve);
        svg += legendLine("#f2d26b", "stroke-width=\"9\"", QStringLiteral("best for its cost"));
        svg += bandLines();
        svg += goodEnough();
        return svg;
    }

private:
    static constexpr const char *kBandColour = "#2a7f3f";

    std::vector<double> costs() const {
        std::vector<double> values;
        for (const ChartPoint &point : m_chart.points()) values.push_back(point.cost);
        return values;
    }
    std::vector<double> errors() const {
        std::vector<double> values;
        for (const ChartPoint &point : m_chart.points()) values.push_back(point.error);
        if (m_chart.band)
            for (const double value : {m_chart.band->low, m_chart.band->high, m_chart.band->limit})
                values.push_back(std::max(value, kSmallestDrawnError));
        return values;
    }
    double height(double error) const { return m_y.at(std::max(error, kSmallestDrawnError)); }

    QByteArray grid() const;
    QByteArray bandArea() const;
    QByteArray bandLines();
    QByteArray goodEnough();
    QByteArray places(const std::vector<ChartPoint> &points) const;
    QByteArray front() const;
    QByteArray draw(const ChartCurve &curve);
    QByteArray legendLine(const char *colour, const char *look, const QString &words);
    double nextRow() { return kTop + 10.0 + 26.0 * m_rows++; }

    const ChartDescription &m_chart;
    LogAxis m_x;
    LogAxis m_y;
    int m_rows = 0; ///< rows of the legend
};

QByteArray Page::grid() const {
    QByteArray svg;
    const char *const faint = "stroke=\"#ddd\"";
    for (int i = m_x.low(); i <= m_x.high(); ++i) {
        const double place = m_x.at(std::pow(10.0, i));
        svg += line(place, kTop, place, kBottom, faint);
        svg += text(place, kBottom + 20.0, "text-anchor=\"middle\"", decade(i));
    }
    const int every = m_y.high() - m_y.low() > 9 ? 2 : 1;
    for (int i = m_y.low(); i <= m_y.high(); i += every) {
        const double place = m_y.at(std::pow(10.0, i));
        svg += line(kLeft, place, kRight, place, faint);
        svg += text(kLeft - 8.0, place + 4.0, "text-anchor=\"end\"", decade(i));
    }
    svg += line(kLeft, kBottom, kRight, kBottom, "stroke=\"black\"") +
           line(kLeft, kTop, kLeft, kBottom, "stroke=\"black\"");
    svg += text(0.5 * (kLeft + kRight), kBottom + 48.0, "text-anchor=\"middle\"", m_chart.costLabel);
    return svg +
           text(-0.5 * (kTop + kBottom), 26.0, "text-anchor=\"middle\" transform=\"rotate(-90)\"", m_chart.errorLabel);
}

QByteArray Page::bandArea() const {
    if (!m_chart.band) return {};
    const double top = height(m_chart.band->high);
    return "<rect x=\"" + number(kLeft) + "\" y=\"" + number(top) + "\" width=\"" + number(kRight - kLeft) +
           "\" height=\"" + number(height(m_chart.band->low) - top) + "\" fill=\"" + kBandColour +
           "\" fill-opacity=\"0.15\"/>\n";
}

QByteArray Page::bandLines() {
    if (!m_chart.band) return {};
    const auto across = [&](double error, const char *look, const QString &words) {
        const QByteArray whole = QByteArray("stroke=\"") + kBandColour + "\" " + look;
        return line(kLeft, height(error), kRight, height(error), whole.constData()) +
               legendLine(kBandColour, look, words);
    };
    QByteArray svg = across(m_chart.band->middle, "stroke-width=\"2\"", m_chart.band->middleText);
    svg += across(m_chart.band->limit, "stroke-width=\"2\" stroke-dasharray=\"7 4\"", m_chart.band->limitText);
    return svg;
}

QByteArray Page::goodEnough() {
    if (!m_chart.goodEnough) return {};
    const auto ring = [](double x, double y) {
        return "<circle cx=\"" + number(x) + "\" cy=\"" + number(y) + "\" r=\"9\" fill=\"none\" stroke=\"" +
               kBandColour + "\" stroke-width=\"3\"/>\n";
    };
    const double row = nextRow();
    return ring(m_x.at(m_chart.goodEnough->cost), height(m_chart.goodEnough->error)) + ring(kRight + 35.0, row) +
           text(kRight + 58.0, row + 4.0, "", QStringLiteral("cheapest good enough"));
}

QByteArray Page::places(const std::vector<ChartPoint> &points) const {
    QByteArray result;
    for (const ChartPoint &point : points)
        result += number(m_x.at(point.cost)) + "," + number(height(point.error)) + ' ';
    return result;
}

QByteArray Page::front() const {
    return "<polyline points=\"" + places(m_chart.front) +
           "\" fill=\"none\" stroke=\"#f2d26b\" stroke-width=\"9\" stroke-linejoin=\"round\" "
           "stroke-linecap=\"round\"/>\n";
}

QByteArray Page::draw(const ChartCurve &curve) {
    QByteArray svg = "<polyline points=\"" + places(curve.points) + "\" fill=\"none\" stroke=\"" + curve.colour +
                     "\" stroke-width=\"2\"/>\n";
    for (const ChartPoint &point : curve.points)
        svg += "<circle cx=\"" + number(m_x.at(point.cost)) + "\" cy=\"" + number(height(point.error)) +
               "\" r=\"4\" fill=\"" + curve.colour + "\"/>\n";
    return svg + legendLine(curve.colour, "stroke-width=\"2\"", curve.name);
}

QByteArray Page::legendLine(const char *colour, const char *look, const QString &words) {
    const double row = nextRow();
    const QByteArray whole = QByteArray("stroke=\"") + colour + "\" " + look;
    return line(kRight + 20.0, row, kRight + 50.0, row, whole.constData()) + text(kRight + 58.0, row + 4.0, "", words);
}

} // namespace

QByteArray tradeSvg(const ChartDescription &chart) {
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + number(kWidth) + ' ' + number(kHeight) +
           "\" font-family=\"sans-serif\" font-size=\"13\">\n"
           "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n" +
           Page(chart).draw() + "</svg>\n";
}

} // namespace inspector
