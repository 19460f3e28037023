#pragma once

#include "../feature/Feature.h"

class QAction;
class QHBoxLayout;

namespace insonate::prepare {

/// The feature for the case itself: the step that imports the case, and facts about the case.
class CaseFeature final : public Feature {
 public:
  CaseFeature(PrepareModel& model, PrepareLayout& layout);

  /// Adds buttons for actions that replace the open case.
  void setCaseActions(QAction* open, QAction* import, QAction* reload);

 private:
  void showOrigin();

  QHBoxLayout* actions_;
};

}  // namespace insonate::prepare
