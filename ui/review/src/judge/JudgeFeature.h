#pragma once

#include "../feature/Feature.h"

class QToolButton;

namespace insonate::review {

class AttemptPage;
class ReplayFeature;

/// Checklists and ratings of the open attempt, in place of 3D.
class JudgeFeature final : public Feature {
 public:
  JudgeFeature(const ReviewModel& model, AttemptPage& page, ReplayFeature& replay);

  /// Sentence about the last action, until the attempt or the time changes; empty if there is none.
  const QString& said() const { return said_; }

  bool isReady() const override;

 private:
  QToolButton* tab_ = nullptr;
  QString said_;
};

}  // namespace insonate::review
