#include <insonate/embedded/stylesheets.h>
#include <insonate/ui/Text.h>
#include <insonate/ui/Theme.h>

#include <QApplication>
#include <QEvent>
#include <QFont>
#include <QLabel>
#include <QLineEdit>
#include <QPalette>
#include <QPlainTextEdit>
#include <QProxyStyle>
#include <QStyle>
#include <QStyleFactory>
#include <QVariant>
#include <QWidget>
#include <utility>

// Resources of a static library are linked only if they are initialized, which must be outside a namespace.
static void useResources() {
  Q_INIT_RESOURCE(theme);
  Q_INIT_RESOURCE(help);
}

namespace insonate::ui {
namespace {

namespace theme = views::theme;

/// Minimum width of a wrapping label, equal for short and long words.
constexpr int kMinWrapped_px = 40;

/// Style that shows text in labels, message boxes and tooltips as plain text, since it may contain names of people and
/// titles of cases. HTML in the text is neither interpreted nor loaded, unless a label is explicitly set to rich text.
/// Overlong words do not widen the window.
class PlainStyle final : public QProxyStyle {
 public:
  using QProxyStyle::polish;
  using QProxyStyle::QProxyStyle;
  void polish(QWidget* widget) override {
    // Tooltips and the text of a message box are labels, too.
    if (auto* label = qobject_cast<QLabel*>(widget)) {
      if (label->textFormat() == Qt::AutoText) label->setTextFormat(Qt::PlainText);
      if (label->wordWrap() && label->minimumWidth() == 0) label->setMinimumWidth(kMinWrapped_px);
    }
    QProxyStyle::polish(widget);
  }
};

/// Clearly darker than typed text; at least 4.5:1 on each ground of a field (WCAG 2, AA).
QColor placeholderColor() {
  return {0x8c, 0x96, 0x9f};
}

/// Gives the placeholders of text fields their color. A style sheet cannot state this color: when it polishes a field,
/// it sets the placeholder in the field's palette to the color of typed text.
class PlaceholderFilter final : public QObject {
 public:
  using QObject::QObject;
  bool eventFilter(QObject* object, QEvent* event) override {
    if (event->type() != QEvent::PaletteChange) return false;
    const bool isField = qobject_cast<QLineEdit*>(object) || qobject_cast<QPlainTextEdit*>(object);
    if (!isField) return false;
    auto* field = static_cast<QWidget*>(object);
    QPalette colors = field->palette();
    if (colors.color(QPalette::PlaceholderText) == placeholderColor()) return false;
    colors.setColor(QPalette::PlaceholderText, placeholderColor());
    field->setPalette(colors);
    return false;
  }
};

QPalette palette() {
  QPalette p;
  p.setColor(QPalette::Window, toQColor(theme::kGround));
  p.setColor(QPalette::WindowText, toQColor(theme::kText));
  p.setColor(QPalette::Base, toQColor(theme::kPanel));
  p.setColor(QPalette::AlternateBase, toQColor(theme::kRaised));
  p.setColor(QPalette::Text, toQColor(theme::kText));
  p.setColor(QPalette::PlaceholderText, placeholderColor());
  p.setColor(QPalette::Button, toQColor(theme::kRaised));
  p.setColor(QPalette::ButtonText, toQColor(theme::kText));
  p.setColor(QPalette::BrightText, toQColor(theme::kText));
  p.setColor(QPalette::Highlight, toQColor(theme::kAccent));
  p.setColor(QPalette::HighlightedText, toQColor(theme::kBlack));
  p.setColor(QPalette::Link, toQColor(theme::kLink));
  p.setColor(QPalette::LinkVisited, toQColor(theme::kLink));
  p.setColor(QPalette::ToolTipBase, toQColor(theme::kRaised));
  p.setColor(QPalette::ToolTipText, toQColor(theme::kText));
  for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    p.setColor(QPalette::Disabled, role, toQColor(theme::kQuiet));
  return p;
}

/// The style sheet names colors by "@name".
QString styleSheet() {
  QString sheet;
  for (const auto& file : embedded::stylesheets::files()) sheet += qt(file.text);
  constexpr std::pair<const char*, views::Color> kNames[] = {
      {"@ground", theme::kGround}, {"@panel", theme::kPanel},     {"@raised", theme::kRaised},
      {"@line", theme::kLine},     {"@text", theme::kText},       {"@quiet", theme::kQuiet},
      {"@accent", theme::kAccent}, {"@link", theme::kLink},       {"@good", theme::kGood},
      {"@danger", theme::kDanger}, {"@caution", theme::kCaution}, {"@black", theme::kBlack}};
  for (const auto& [name, value] : kNames) sheet.replace(QLatin1String(name), toQColor(value).name());
  return sheet;
}

}  // namespace

QColor toQColor(views::Color c) {
  return {c.red, c.green, c.blue};
}

void setRole(QWidget* widget, const char* role) {
  const QVariant now = QLatin1String(role);
  if (widget->property("role") == now) return;
  widget->setProperty("role", now);
  // Polishing reads the style sheet, once only.
  if (widget->testAttribute(Qt::WA_WState_Polished)) widget->style()->unpolish(widget), widget->style()->polish(widget);
}

void applyTheme(QApplication& application) {
  useResources();
  QApplication::setStyle(new PlainStyle(QStyleFactory::create(QStringLiteral("Fusion"))));
  QApplication::setPalette(palette());
  QFont font = QApplication::font();
  font.setPointSizeF(10);
  font.setStyleHint(QFont::SansSerif);
  QApplication::setFont(font);
  application.setStyleSheet(styleSheet());
  application.installEventFilter(new PlaceholderFilter(&application));
}

}  // namespace insonate::ui
