#include <insonate/ui/ValueSlider.h>

#include <gtest/gtest.h>

#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QScrollArea>
#include <QScrollBar>
#include <QSlider>
#include <QSpinBox>
#include <QTest>
#include <QVBoxLayout>
#include <QWheelEvent>
#include <memory>

namespace insonate {
namespace {

/// A panel that scrolls, with one field of each kind.
class QuietFields : public testing::Test {
 protected:
  explicit QuietFields(QWidget* window = new QWidget) : window_(window) {
    auto* panel = new QWidget;
    auto* box = new QVBoxLayout(panel);
    number_->setRange(0, 100), number_->setValue(50);
    choice_->addItems({"a", "b", "c"}), choice_->setCurrentIndex(1);
    slider_->setRange(0, 100), slider_->setValue(50);
    for (QWidget* field : {static_cast<QWidget*>(number_), static_cast<QWidget*>(choice_),
                           static_cast<QWidget*>(slider_), static_cast<QWidget*>(text_)})
      box->addWidget(field);
    blank_->setMinimumHeight(600);
    box->addWidget(blank_);
    area_->setWidget(panel), area_->setWidgetResizable(true);
    auto* all = new QVBoxLayout(window_.get());
    all->addWidget(area_);
    window_->resize(240, 200);
    window_->show();
    QApplication::setActiveWindow(window_.get());
    EXPECT_TRUE(QTest::qWaitForWindowExposed(window_.get()));
    window_->setFocus();
  }

  /// Returns true if the field has taken the event; otherwise Qt passes it on to the panel.
  bool wheel(QWidget& over, Qt::KeyboardModifiers modifiers = {}) {
    const QPoint at = over.rect().center();
    QWheelEvent event(QPointF(at), over.mapToGlobal(at), {}, {0, -120}, Qt::NoButton, modifiers, Qt::NoScrollPhase,
                      false);
    QApplication::sendEvent(&over, &event);
    return event.isAccepted();
  }

  QSpinBox* number_ = new QSpinBox;
  QComboBox* choice_ = new QComboBox;
  QSlider* slider_ = new QSlider(Qt::Horizontal);
  QLineEdit* text_ = new QLineEdit;
  QLabel* blank_ = new QLabel;
  QScrollArea* area_ = new QScrollArea;
  const std::unique_ptr<QWidget> window_;
};

TEST_F(QuietFields, TheWheelScrollsThePanel) {
  for (QWidget* field :
       {static_cast<QWidget*>(number_), static_cast<QWidget*>(choice_), static_cast<QWidget*>(slider_)}) {
    EXPECT_FALSE(wheel(*field));
    EXPECT_FALSE(field->hasFocus());
  }
  EXPECT_EQ(number_->value(), 50);
  EXPECT_EQ(choice_->currentIndex(), 1);
  EXPECT_EQ(slider_->value(), 50);
  EXPECT_TRUE(wheel(*area_->verticalScrollBar())) << "scroll bars scroll";
}

TEST_F(QuietFields, AFocusedFieldAndControlTurnIt) {
  slider_->setFocus();
  EXPECT_TRUE(wheel(*slider_));
  EXPECT_LT(slider_->value(), 50);
  EXPECT_TRUE(wheel(*number_, Qt::ControlModifier));
  EXPECT_LT(number_->value(), 50);
}

TEST_F(QuietFields, AClickElsewhereAndReturnAndEscapeGiveTheKeyboardBack) {
  text_->setFocus();
  QTest::mouseClick(text_, Qt::LeftButton);
  EXPECT_TRUE(text_->hasFocus()) << "a click into the field itself";
  QTest::mouseClick(blank_, Qt::LeftButton);
  EXPECT_FALSE(text_->hasFocus());
  for (const Qt::Key key : {Qt::Key_Return, Qt::Key_Escape}) {
    number_->setFocus();
    number_->selectAll();
    QTest::keyClicks(number_, "7");
    QTest::keyClick(number_, key);
    EXPECT_TRUE(QTest::qWaitFor([&] { return !number_->hasFocus(); }, 1000));
    EXPECT_EQ(number_->value(), 7);
  }
}

class QuietFieldsOfADialog : public QuietFields {
 protected:
  QuietFieldsOfADialog() : QuietFields(new QDialog) {}
};

TEST_F(QuietFieldsOfADialog, KeepReturnForTheButtons) {
  text_->setFocus();
  QTest::keyClick(text_, Qt::Key_Return);
  QTest::qWait(20);
  EXPECT_TRUE(text_->hasFocus());
}

}  // namespace
}  // namespace insonate
