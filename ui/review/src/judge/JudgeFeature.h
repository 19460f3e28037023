#pragma once

#include "../feature/Feature.h"

class QToolButton;

namespace insonate::review {

class AttemptPage;
class ReplayFeature;

/// Checklists and ratings of the open attempt, which are shown in place of 3D.
class JudgeFeature final : public Feature {
 public:
  JudgeFeature(const ReviewModel& model, AttemptPage& page, ReplayFeature& replay);

  /// Sentence about the last action; empty if there is none, or when the user has moved to another time or attempt
  /// since.
  const QString& statusText() const { return statusText_; }

  bool isReady() const override;

 private:
  QToolButton* tab_ = nullptr;
  QString statusText_;
};

}  // namespace insonate::review
