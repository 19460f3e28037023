#pragma once

#include "SharedModel.h"
#include "layout/CaseViews.h"

#include <insonate/prepare/PrepareWorkspace.h>
#include <insonate/tissue/Labels.h>
#include <insonate/ui/TaskBar.h>
#include <insonate/ui/ValueSlider.h>
#include <insonate/ui/ViewWidget.h>

#include <gtest/gtest.h>
#include <support/SmallCase.h>
#include <support/TestData.h>
#include <ui/support/Patience.h>

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QColorDialog>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPushButton>
#include <QScrollArea>
#include <QSettings>
#include <QSpinBox>
#include <QTableView>
#include <QToolButton>
#include <QtTest/QTest>
#include <optional>

namespace insonate::prepare {

using test::kPatience_ms;
inline constexpr int kEye = 0, kLock = 1, kColor = 2, kName = 3, kState = 4, kVolume = 5, kTissue = 6;

/// The workspace by itself, shown, with a small case.
class PrepareWindow : public testing::Test {
 protected:
  void SetUp() override {
    workspace_ = std::make_unique<PrepareWorkspace>(tasks_);
    workspace_->resize(1200, 760);
    workspace_->show();
    workspace_->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(workspace_.get()));
    shared_.emplace(modelOf(*workspace_));
  }

  static std::shared_ptr<const PatientCase> patient() {
    static const auto made = std::make_shared<const PatientCase>(test::smallCase());
    return made;
  }

  void openCase(std::shared_ptr<const PatientCase> one = patient()) {
    workspace_->setCase(std::move(one));
    ASSERT_TRUE(QTest::qWaitFor([&] { return workspace_->isReady(); }, kPatience_ms))
        << workspace_->statusText().toStdString();
  }

  template <class T>
  T* child(const char* name) {
    T* found = workspace_->findChild<T*>(name);
    EXPECT_TRUE(found) << name;
    return found;
  }
  QTableView* table() { return child<QTableView>("structures"); }
  int rowOf(std::uint8_t label) {
    const auto& all = shared_->structures.labels();
    return int(std::ranges::find(all, label) - all.begin());
  }
  void clickCell(std::uint8_t label, int column) {
    const QRect cell = table()->visualRect(table()->model()->index(rowOf(label), column));
    QTest::mouseClick(table()->viewport(), Qt::LeftButton, {}, cell.center());
  }
  QWidget* canvas(const char* view) { return child<ui::ViewWidget>(view)->focusProxy(); }
  views::MprView& axial() { return static_cast<CaseViews*>(child<QWidget>("caseViews"))->slice(0); }
  views::SceneView& scene() { return *static_cast<CaseViews*>(child<QWidget>("caseViews"))->sharedScene(); }
  void key(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QTest::keyClick(canvas("Axial slice"), key, modifiers);
  }

  ui::TaskBar tasks_;
  std::unique_ptr<PrepareWorkspace> workspace_;
  std::optional<PrepareModel> shared_;
};

}  // namespace insonate::prepare
