#include <insonate/ui/Theme.h>

#include <gtest/gtest.h>
#include <support/TestData.h>

#include <QApplication>
#include <QLineEdit>
#include <QPalette>
#include <QPlainTextEdit>
#include <QRegularExpression>
#include <QString>
#include <QtTest/QTest>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace {

namespace theme = insonate::views::theme;

constexpr double kLeast = 7;

double linear(int value) {
  const double share = value / 255.0;
  return share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4);
}

double luminance(const QColor& c) {
  return 0.2126 * linear(c.red()) + 0.7152 * linear(c.green()) + 0.0722 * linear(c.blue());
}

/// WCAG 2.
double contrast(const QColor& a, const QColor& b) {
  const auto [low, high] = std::minmax({luminance(a), luminance(b)});
  return (high + 0.05) / (low + 0.05);
}

struct Rule {
  QString selector;
  QColor text, ground;  ///< invalid where the rule does not say
};

/// Rules of the application's style sheet about text and its ground.
std::vector<Rule> rules() {
  std::vector<Rule> found;
  static const QRegularExpression rule(QStringLiteral("([^{}]+)\\{([^}]*)\\}"));
  static const QRegularExpression text(QStringLiteral("(?:^|;| )(?:selection-)?color:\\s*(#[0-9a-f]{6})"));
  static const QRegularExpression ground(
      QStringLiteral("(?:^|;| )(?:selection-)?background(?:-color)?:\\s*(#[0-9a-f]{6})"));
  auto all = rule.globalMatch(qApp->styleSheet());
  while (all.hasNext()) {
    const auto one = all.next();
    const auto said = text.match(one.captured(2)), on = ground.match(one.captured(2));
    found.push_back({one.captured(1).trimmed(), said.hasMatch() ? QColor(said.captured(1)) : QColor(),
                     on.hasMatch() ? QColor(on.captured(1)) : QColor()});
  }
  return found;
}

TEST(Contrast, KnownValues) {
  EXPECT_NEAR(contrast(Qt::white, Qt::black), 21, 1e-9);
  EXPECT_NEAR(contrast(QColor(0x77, 0x77, 0x77), Qt::white), 4.48, 0.01);
}

TEST(Contrast, TextIsSevenToOneWhereverTheStyleSheetPutsIt) {
  const QColor grounds[] = {insonate::ui::toQColor(theme::kGround), insonate::ui::toQColor(theme::kPanel),
                            insonate::ui::toQColor(theme::kRaised)};
  int texts = 0;
  for (const Rule& rule : rules()) {
    if (!rule.text.isValid()) continue;
    ++texts;
    if (rule.ground.isValid() && rule.selector != "QWidget") {
      EXPECT_GE(contrast(rule.text, rule.ground), kLeast) << rule.selector.toStdString();
      continue;
    }
    for (const QColor& ground : grounds)
      EXPECT_GE(contrast(rule.text, ground), kLeast)
          << rule.selector.toStdString() << " on " << ground.name().toStdString();
  }
  EXPECT_GT(texts, 10) << "the style sheet is read";
}

TEST(Contrast, EveryGroundCarriesText) {
  const QColor text = insonate::ui::toQColor(theme::kText);
  for (const Rule& rule : rules()) {
    // A rule with the accent behind text states the text's color itself.
    if (!rule.ground.isValid() || rule.text.isValid() || luminance(rule.ground) > 0.2) continue;
    EXPECT_GE(contrast(text, rule.ground), kLeast) << rule.selector.toStdString();
  }
}

TEST(Contrast, ThePaletteIsSevenToOne) {
  const QPalette palette = QApplication::palette();
  using enum QPalette::ColorRole;
  for (const auto& [text, ground] : {std::pair{WindowText, Window},
                                     {Text, Base},
                                     {Text, AlternateBase},
                                     {ButtonText, Button},
                                     {HighlightedText, Highlight},
                                     {Link, Base},
                                     {Link, Window},
                                     {ToolTipText, ToolTipBase}})
    for (const auto group : {QPalette::Active, QPalette::Inactive, QPalette::Disabled})
      EXPECT_GE(contrast(palette.color(group, text), palette.color(group, ground)), kLeast) << text << " on " << ground;
}

/// The color of the letters that the field draws, the brightest one.
QColor lettersOf(QWidget& field) {
  const QImage image = field.grab().toImage();
  QColor brightest = Qt::black;
  for (int y = 4; y < image.height() - 4; ++y)
    for (int x = 4; x < image.width() - 4; ++x)
      if (const QColor one = image.pixelColor(x, y); luminance(one) > luminance(brightest)) brightest = one;
  return brightest;
}

template <class Field>
void expectDimPlaceholder(void (Field::*setText)(const QString&)) {
  Field field;
  field.setFocusPolicy(Qt::NoFocus);  // shows no text cursor
  field.setPlaceholderText(QStringLiteral("MMM"));
  field.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&field));
  const QColor placeholder = lettersOf(field);
  (field.*setText)(QStringLiteral("MMM"));
  const QColor typed = lettersOf(field), ground = insonate::ui::toQColor(theme::kGround);
  EXPECT_GE(contrast(placeholder, ground), 4.5) << placeholder.name().toStdString();
  EXPECT_GE(contrast(typed, placeholder), 2)
      << placeholder.name().toStdString() << " as " << typed.name().toStdString();
}

TEST(Contrast, PlaceholdersAreReadableAndClearlyDimmerThanTypedText) {
  expectDimPlaceholder(&QLineEdit::setText);
  expectDimPlaceholder(&QPlainTextEdit::setPlainText);
  for (const auto ground : {theme::kGround, theme::kPanel, theme::kRaised})
    EXPECT_GE(contrast(QApplication::palette().color(QPalette::PlaceholderText), insonate::ui::toQColor(ground)), 4.5);
}

TEST(Contrast, WordsOverPicturesAreSevenToOne) {
  for (const auto color : {theme::kText, theme::kQuiet, theme::kCaution})
    EXPECT_GE(contrast(insonate::ui::toQColor(color), Qt::black), kLeast);
}

}  // namespace
