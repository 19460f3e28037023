#pragma once

#include "../feature/Feature.h"

namespace insonate::prepare {

class GuidePage;
class GuideSession;
class Section;

/// The feature for the guide: labels from a few clicks, step by step.
class GuideFeature final : public Feature {
 public:
  /// `tool`: section of the selected tool. The section's remark says that the guide waits.
  GuideFeature(PrepareModel& model, PrepareLayout& layout, Section& tool);

 private:
  void choosePage();

  GuideSession* guide_;
  GuidePage* page_;
  bool isChosen_ = true;  ///< true: a page was selected for this case
};

}  // namespace insonate::prepare
