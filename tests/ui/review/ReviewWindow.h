#pragma once

#include "ReviewSession.h"
#include "replay/Timeline.h"

#include <insonate/review/ReviewWorkspace.h>
#include <insonate/simulator/ScriptedSession.h>
#include <insonate/ui/TaskBar.h>
#include <insonate/ui/ViewWidget.h>

#include <gtest/gtest.h>
#include <support/SmallCase.h>
#include <ui/support/Patience.h>

#include <QListWidget>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QtTest/QTest>
#include <memory>
#include <string>

namespace insonate::review {

using test::kPatience_ms;

inline std::shared_ptr<const PatientCase> block() {
  static const auto made = std::make_shared<const PatientCase>(test::smallAttemptCase());
  return made;
}

/// The block whose vein has a name.
inline PatientCase namedBlock() {
  PatientCase named = *block();
  named.manifest.vessels = {{"right internal jugular vein", kVein, {{{0, 12, 0}, 4.5}}}};
  return named;
}

/// Two passes over the vein of the small block: through its back wall; and, with the same needle, into it, aspirating.
inline const char* kTwoPasses = R"({"acts": [{"tilt_deg": 15}, {"probe": "auto"},
  {"needle": {"from_mm": [0, -5, 0], "to": "vein"}}, {"advance_mm": 27}, {"withdraw_mm": 27},
  {"aspirate": true}, {"advance_mm": 17}, {"wait_s": 1.5}, {"aspirate": false}, {"probe": null}, {"wait_s": 0.5}]})";

inline QString recorded(const QString& file, const char* text = kTwoPasses, const PatientCase& patient = *block()) {
  const auto script = readSessionScript(text, patient);
  if (!script) throw std::runtime_error(script.error().message);
  const auto outcome = runSession(*script, patient, "insonate test", file.toStdString(), {});
  if (!outcome) throw std::runtime_error(outcome.error().message);
  return file;
}

/// The workspace by itself, shown, with the small block.
class ReviewWindow : public testing::Test {
 protected:
  void SetUp() override {
    workspace_ = std::make_unique<ReviewWorkspace>(tasks_);
    workspace_->resize(1200, 760);
    workspace_->show();
    workspace_->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(workspace_.get()));
    session_ = workspace_->findChild<ReviewSession*>();
    ASSERT_TRUE(session_);
  }

  void open(const QString& file) {
    workspace_->openAttempt(file);
    ASSERT_TRUE(QTest::qWaitFor([&] { return session_->attempt() && !session_->isOpening(); }, kPatience_ms));
  }
  void settle() {
    ASSERT_TRUE(QTest::qWaitFor([&] { return workspace_->isReady(); }, kPatience_ms))
        << workspace_->statusText().toStdString();
  }
  /// With the case there, and all that belongs on the screen.
  void openAll(const QString& file) {
    workspace_->setCase(block());
    open(file);
    settle();
  }
  template <class T>
  T* child(const char* name) {
    T* found = workspace_->findChild<T*>(name);
    EXPECT_TRUE(found) << name;
    return found;
  }
  Timeline& timeline() { return *static_cast<Timeline*>(child<QWidget>("timeline")); }
  void key(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QTest::keyClick(&timeline(), key, modifiers);
  }
  double time_s() const { return double(session_->time_us()) * 1e-6; }

  QTemporaryDir home_;
  ui::TaskBar tasks_;
  std::unique_ptr<ReviewWorkspace> workspace_;
  ReviewSession* session_ = nullptr;
};

}  // namespace insonate::review
