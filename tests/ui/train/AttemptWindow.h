#pragma once

#include "NeedleWindow.h"
#include "attempt/AttemptControl.h"

#include <insonate/procedure/AttemptRecording.h>
#include <insonate/ui/Attempts.h>

#include <QDir>
#include <QLabel>

namespace insonate::train {

/// An attempt as a trainee makes it, by keys and buttons.
class AttemptWindow : public NeedleWindow {
 protected:
  void SetUp() override {
    NeedleWindow::SetUp();
    QDir(folder()).removeRecursively();
    attempt_ = workspace_->findChild<AttemptControl*>();
    ASSERT_TRUE(attempt_);
  }

  static QString folder() { return ui::attemptsFolder(); }
  static QStringList files() { return QDir(folder()).entryList(QDir::Files); }
  Result<AttemptRecording> recorded() {
    const QStringList all = files();
    if (all.size() != 1) return fail(std::to_string(all.size()) + " files");
    return AttemptRecording::open(QDir(folder()).filePath(all.front()).toStdString());
  }
  QString text(const char* label) { return child<QLabel>(label)->text(); }
  bool shown(const char* widget) { return child<QWidget>(widget)->isVisible(); }
  void start() {
    key(Qt::Key_Return, Qt::ControlModifier);
    ASSERT_TRUE(waitFor([&] { return attempt_->isRunning(); })) << workspace_->statusText().toStdString();
  }
  void finish() {
    ASSERT_TRUE(waitFor([&] { return attempt_->view().time_s > 1.2; })) << "the key finishes nothing at once";
    key(Qt::Key_Return, Qt::ControlModifier);
    ASSERT_TRUE(waitFor([&] { return attempt_->state() == AttemptControl::State::Over; }));
  }

  AttemptControl* attempt_ = nullptr;
};

}  // namespace insonate::train
