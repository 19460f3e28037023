#pragma once

#include "ReviewSession.h"

#include <insonate/review/ReviewWorkspace.h>
#include <insonate/views/UltrasoundView.h>

#include <QStringList>
#include <optional>

class QKeyEvent;
class QLabel;
class QSplitter;
class QButtonGroup;
class QStackedLayout;
class QStackedWidget;
class QToolButton;

namespace insonate::ui {
class ViewWidget;
}

namespace insonate::review {

class AttemptList;
class JudgeDesk;
class PathPane;
class ReviewHome;
class ReplayScene;
class Timeline;

/// The parts of the workspace and the connections between them.
class ReviewWorkspace::Parts : public QObject {
 public:
  Parts(ReviewWorkspace& workspace, ui::TaskBar& tasks);
  ~Parts() override;

  ui::TaskBar& tasks;
  ReviewSession& session;  ///< child of the workspace, deleted after its widgets
  JudgeDesk* judging;      ///< trainee and judgements of the open attempt
  AttemptList* list = nullptr;
  ReviewHome* home = nullptr;
  bool ready = false;
  /// Sentence about the last action, until the attempt or the time changes; empty if there is none.
  const QString& said() const { return said_; }

  bool key(const QKeyEvent& event, bool act);
  /// Saves the open attempt's result as a page.
  void saveResult(const QString& file);
  /// Handles a key event by the key table before the focused widget does.
  bool keyEvent(QEvent* event);
  void saveLayout(QSettings& settings) const;
  void restoreLayout(QSettings& settings);

 private:
  enum Tab { kReplayTab, kResultTab };

  QWidget* buildBar();
  QWidget* buildCentre();
  QWidget* buildTabs();
  void showTab(int tab);
  void showBelow();
  void exportResult();
  void connectParts();
  void showAttempt();
  void showNotice();
  static std::optional<QString> keptVersion(const AttemptHeader& header);
  void openKeptVersion();
  QString pictureWords() const;
  void showPicture();
  void findCase();
  void refreshReady();

  ReviewWorkspace& workspace_;
  QString said_;
  QStackedLayout* pages_;
  QWidget* page_;
  QLabel *title_ = nullptr, *facts_ = nullptr, *notice_ = nullptr;
  QSplitter* columns_ = nullptr;
  std::shared_ptr<views::UltrasoundView> picture_;
  std::shared_ptr<const LiveFrame> shown_;
  ui::ViewWidget* pictureWidget_ = nullptr;
  ReplayScene* scene_ = nullptr;
  Timeline* timeline_ = nullptr;
  QStackedWidget* centre_ = nullptr;  ///< shows the image or the result
  PathPane* path_ = nullptr;
  QButtonGroup* tabs_ = nullptr;
  QToolButton* look_ = nullptr;      ///< shows and hides the panel of the 3D view
  QToolButton* judge_ = nullptr;     ///< shows forms in place of 3D
  QStackedWidget* right_ = nullptr;  ///< shows 3D or forms
  bool keptWanted_ = false;          ///< the case version on which this attempt was made has been requested
};

}  // namespace insonate::review
