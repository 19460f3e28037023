#include <insonate/ui/ErrorPanel.h>

#include <gtest/gtest.h>

#include <QLabel>
#include <QToolButton>
#include <QtTest/QTest>

namespace {

using insonate::ui::ErrorPanel;

QToolButton* button(ErrorPanel& panel, const QString& text) {
  for (auto* one : panel.findChildren<QToolButton*>())
    if (one->text() == text || one->accessibleName() == text) return one;
  return nullptr;
}

TEST(ErrorPanel, SaysWhatAndWhatToDoAndFoldsDetails) {
  ErrorPanel panel;
  EXPECT_TRUE(panel.isHidden());
  panel.showError("The labels cannot be read.\nline 3: no space", "Open another case.", "labels.seg.nrrd");
  EXPECT_TRUE(panel.isVisible());
  EXPECT_EQ(panel.message(), "The labels cannot be read. Open another case.");
  EXPECT_EQ(panel.details(), "line 3: no space\nlabels.seg.nrrd");
  const auto detailsShown = [&panel] {
    for (const QLabel* label : panel.findChildren<QLabel*>())
      if (label->text() == panel.details()) return label->isVisible();
    return false;
  };
  EXPECT_FALSE(detailsShown());
  QTest::mouseClick(button(panel, "Details"), Qt::LeftButton);
  EXPECT_TRUE(detailsShown());
}

TEST(ErrorPanel, HasNoFoldWithoutDetailsAndCloses) {
  ErrorPanel panel;
  panel.showError("There is no such file.");
  EXPECT_FALSE(button(panel, "Details")->isVisible());
  QTest::mouseClick(button(panel, "Close this message"), Qt::LeftButton);
  EXPECT_TRUE(panel.isHidden());
  panel.showError("There is no such file.");
  QTest::keyClick(&panel, Qt::Key_Escape);
  EXPECT_TRUE(panel.isHidden());
}

TEST(ErrorPanel, ShowsMarkupAsItIs) {
  ErrorPanel panel;
  panel.showError("<b>evil</b>.nrrd cannot be read.");
  EXPECT_EQ(panel.message(), "<b>evil</b>.nrrd cannot be read.");
  for (const QLabel* label : panel.findChildren<QLabel*>())
    if (!label->text().isEmpty()) {
      EXPECT_EQ(label->textFormat(), Qt::PlainText);
    }
}

}  // namespace
