#pragma once

#include "../feature/Feature.h"

namespace insonate::prepare {

class Section;

/// The feature for the check: the findings, each of which leads to its position, and the difficulty.
class CheckFeature final : public Feature {
 public:
  CheckFeature(PrepareModel& model, PrepareLayout& layout);

 private:
  void showCheck(bool isShown);
  void refresh();

  Section* findings_;
};

}  // namespace insonate::prepare
