#pragma once

#include "../feature/Feature.h"
#include "CommentController.h"

namespace insonate::ui {
class Account;
}

namespace insonate::review {

class AttemptPage;
class CommentPane;
class ReplayFeature;

/// Comments at times of the replay: their marks on the timeline, the list of comments, and the commands to write and to
/// remove a comment.
class CommentFeature final : public Feature {
 public:
  CommentFeature(const ReviewModel& model, AttemptPage& page, ReplayFeature& replay);
  void setAccount(ui::Account& account) { controller_.setAccount(account); }

  bool isReady() const override { return !controller_.isReading(); }

 private:
  void addCommands();
  void addStep(int by, int key, const QString& text, const QString& does);
  void showOn(ReplayFeature& replay) const;

  CommentController controller_;
  CommentPane* pane_ = nullptr;
};

}  // namespace insonate::review
