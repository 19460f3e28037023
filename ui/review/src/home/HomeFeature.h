#pragma once

#include "../feature/Feature.h"

class QAction;

namespace insonate::ui {
class Account;
}

namespace insonate::review {

class AttemptList;
class ReviewHome;

/// The start page: recordings, and for signed-in users the class and its people. Opens the attempt that the user
/// selects.
class HomeFeature final : public Feature {
 public:
  explicit HomeFeature(const ReviewModel& model);

  QWidget* page();
  /// Adds a button beside the list of recordings. The action belongs to the caller.
  void addOpenAction(QAction* action);
  void setAccount(ui::Account& account);
  /// Reads the folder of recordings again.
  void refresh();
  /// Opens the menu that saves the present page.
  void showSaving();
  /// See ReviewHome::unwrittenPortfolio().
  QString unwrittenPortfolio() const;
  /// Sentence about the next thing to do.
  QString statusText() const;

  bool isReady() const override;

 private:
  AttemptList* list_;
  ReviewHome* home_;
};

}  // namespace insonate::review
