// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/parts/theme.h"

#include "ui/parts/path_icon.h"

#include <QApplication>
#include <QEvent>
#include <QFont>
#include <QPainter>
#include <QProxyStyle>
#include <QStyleOptionButton>
#include <QWidget>

#include <algorithm>
#include <cmath>

namespace inspector::ui {

namespace {

struct SystemLook {
    QPalette palette;
    QString style;
    QFont font;
};

/// The desktop's style, palette and font, before any others were chosen.
const SystemLook &systemLook() {
    static const SystemLook look{QApplication::palette(), QApplication::style()->objectName(), QApplication::font()};
    return look;
}

struct Shades {
    QRgb window, base, alternate, button, text, faint, highlight, link, light, dark;
};

constexpr Shades kLight{0xfff3f4f5, 0xffffffff, 0xfff0f2f4, 0xfff8f9fa, 0xff1d2125,
                        0xff8b9197, 0xff2f6fb0, 0xff2464a4, 0xffffffff, 0xffb4b9be};
constexpr Shades kDark{0xff26292d, 0xff1b1d20, 0xff222529, 0xff32363b, 0xffe6e8ea,
                       0xff7f868d, 0xff3d7fc4, 0xff7db4ec, 0xff454a50, 0xff15171a};

QPalette paletteOf(const Shades &shades) {
    QPalette palette(QColor(shades.button), QColor(shades.window));
    const auto set = [&palette](QPalette::ColorRole role, QRgb colour) { palette.setColor(role, QColor(colour)); };
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText})
        set(role, shades.text);
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        palette.setColor(QPalette::Disabled, role, QColor(shades.faint));
    set(QPalette::PlaceholderText, shades.faint);
    set(QPalette::Base, shades.base);
    set(QPalette::AlternateBase, shades.alternate);
    set(QPalette::ToolTipBase, shades.button);
    set(QPalette::Light, shades.light);
    set(QPalette::Midlight, shades.button);
    set(QPalette::Mid, shades.dark);
    set(QPalette::Dark, shades.dark);
    set(QPalette::Shadow, 0xff000000);
    set(QPalette::Highlight, shades.highlight);
    set(QPalette::HighlightedText, 0xffffffff);
    palette.setColor(QPalette::Disabled, QPalette::Highlight, QColor(shades.faint));
    set(QPalette::Link, shades.link);
    return palette;
}

/// The chosen size of the texts, relative to the system's.
double textScale() { return QApplication::font().pointSizeF() / systemLook().font.pointSizeF(); }

/// Fusion, except for this. On dark palettes it frames an empty check box, in widgets and lists alike, with a darker
/// shade of the window and fills it with the base, which is hardly visible there; nor is its frame around what has the
/// keyboard, on any palette, nor on dark ones the arrows that open the rest of a toolbar. Rows of lists are as high as
/// their text, and so hard to tell apart. And icons and check boxes don't grow with the texts.
class ThemeStyle : public QProxyStyle {
public:
    ThemeStyle()
        : QProxyStyle(QStringLiteral("fusion")) {}

    void drawPrimitive(PrimitiveElement element, const QStyleOption *option, QPainter *painter,
                       const QWidget *widget) const override {
        const auto *button = qstyleoption_cast<const QStyleOptionButton *>(option);
        if (element == PE_IndicatorCheckBox && button && isDark(button->palette)) {
            QStyleOptionButton box(*button);
            box.palette.setColor(QPalette::Base, box.palette.color(QPalette::Light));
            return QProxyStyle::drawPrimitive(element, &box, painter, widget);
        }
        if (element == PE_FrameFocusRect) return frame(*option, option->rect, *painter);
        QProxyStyle::drawPrimitive(element, option, painter, widget);
        const bool isPanel = element == PE_PanelButtonCommand && option->state.testFlag(State_HasFocus);
        if (isPanel) frame(*option, option->rect.adjusted(1, 1, -1, -1), *painter); // inside its border
    }

    void drawComplexControl(ComplexControl control, const QStyleOptionComplex *option, QPainter *painter,
                            const QWidget *widget) const override {
        QProxyStyle::drawComplexControl(control, option, painter, widget);
        if (control == CC_Slider && option->state.testFlag(State_HasFocus)) frame(*option, option->rect, *painter);
    }

    QIcon standardIcon(StandardPixmap icon, const QStyleOption *option, const QWidget *widget) const override {
        const bool isRest = icon == SP_ToolBarHorizontalExtensionButton;
        return isRest ? glyphIcon(Glyph::More) : QProxyStyle::standardIcon(icon, option, widget);
    }

    int pixelMetric(PixelMetric metric, const QStyleOption *option, const QWidget *widget) const override {
        const int usual =
            metric == PM_ToolBarIconSize ? kToolBarIcon : QProxyStyle::pixelMetric(metric, option, widget);
        return std::ranges::find(kGrowing, metric) == kGrowing.end() ? usual : int(std::lround(textScale() * usual));
    }

    QSize sizeFromContents(ContentsType type, const QStyleOption *option, const QSize &size,
                           const QWidget *widget) const override {
        constexpr int kRoom = 7; // pixels, above and below the text
        const QSize whole = QProxyStyle::sizeFromContents(type, option, size, widget);
        return type == CT_ItemViewItem ? whole + QSize(0, kRoom) : whole;
    }

private:
    static constexpr int kToolBarIcon = 20; // pixels
    static constexpr std::array kGrowing{PM_ToolBarIconSize,          PM_SmallIconSize,      PM_ButtonIconSize,
                                         PM_IndicatorWidth,           PM_IndicatorHeight,    PM_ExclusiveIndicatorWidth,
                                         PM_ExclusiveIndicatorHeight, PM_MenuButtonIndicator};

    /// Around what has been given the keyboard by keys.
    static void frame(const QStyleOption &option, const QRectF &place, QPainter &painter) {
        if (!option.state.testFlag(State_KeyboardFocusChange)) return;
        painter.save();
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(option.palette.color(isDark(option.palette) ? QPalette::Link : QPalette::Highlight));
        painter.setBrush(Qt::NoBrush);
        painter.drawRoundedRect(place.adjusted(0.5, 0.5, -0.5, -0.5), 2.0, 2.0);
        painter.restore();
    }
};

} // namespace

QPalette completed(QPalette desktops) {
    if (!isDark(desktops)) return desktops;
    QColor faint = desktops.color(QPalette::Text);
    faint.setAlphaF(0.5F);
    desktops.setColor(QPalette::PlaceholderText, faint);
    return desktops;
}

void applyTheme(Theme theme) {
    const SystemLook &system = systemLook();
    if (theme == Theme::System) {
        if (system.style == QLatin1String("fusion"))
            QApplication::setStyle(new ThemeStyle);
        else
            QApplication::setStyle(system.style);
        QApplication::setPalette(completed(system.palette));
        return;
    }
    // Only Fusion respects every palette; desktop styles use their own colours.
    QApplication::setStyle(new ThemeStyle);
    QApplication::setPalette(paletteOf(theme == Theme::Dark ? kDark : kLight));
}

void applyTextScale(double scale) {
    QFont font = systemLook().font;
    font.setPointSizeF(scale * font.pointSizeF());
    if (font == QApplication::font()) return;
    QApplication::setFont(font);
    if (dynamic_cast<ThemeStyle *>(QApplication::style())) QApplication::setStyle(new ThemeStyle); // its sizes are new
}

bool isDark(const QPalette &palette) {
    return palette.color(QPalette::Window).lightnessF() < palette.color(QPalette::WindowText).lightnessF();
}

/// Hues that colour-blind people can tell apart (blue, orange, and grey for the total).
Accents accentsFor(const QPalette &palette) {
    if (isDark(palette))
        return {QColor(0x5aa9f5), QColor(0xf5a04a), QColor(0xd8dadd), QColor(0x5c4a12),
                QColor(0xff8a3c), QColor(0x57a8ff), QColor(0xff5aa8), QColor(0xff7b72)};
    return {QColor(0x1f6fc0), QColor(0xc96a0c), QColor(0x3a3f45), QColor(0xffefc2),
            QColor(0xd64a00), QColor(0x0a5fd0), QColor(0xc2185b), QColor(0xc62828)};
}

AlarmText::AlarmText(QWidget &widget, QPalette::ColorRole role)
    : QObject(&widget)
    , m_widget(widget)
    , m_role(role) {
    widget.installEventFilter(this);
}

void AlarmText::setOn(bool isOn) {
    if (isOn == m_isOn) return;
    m_isOn = isOn;
    isOn ? takeColour() : m_widget.setPalette({});
}

bool AlarmText::isOn(const QWidget &widget) {
    return std::ranges::any_of(widget.children(), [](const QObject *child) {
        const auto *alarm = dynamic_cast<const AlarmText *>(child);
        return alarm && alarm->m_isOn;
    });
}

bool AlarmText::eventFilter(QObject *, QEvent *event) {
    if (m_isOn && event->type() == QEvent::PaletteChange) takeColour();
    return false;
}

/// A copy of the widget's palette would keep the theme's other colours, too.
void AlarmText::takeColour() {
    const QColor alarm = accentsFor(QApplication::palette()).alarm;
    if (m_widget.palette().color(m_role) == alarm) return; // this call caused the change
    QPalette own;
    own.setColor(m_role, alarm);
    m_widget.setPalette(own);
}

} // namespace inspector::ui
