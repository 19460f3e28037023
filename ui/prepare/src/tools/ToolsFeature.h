#pragma once

#include "../feature/Feature.h"

namespace insonate::ui {
class HistogramEditor;
}

namespace insonate::prepare {

class Section;
class ToolSession;

/// The feature for label tools: the palette, the selected tool with its panel, and the mouse on slices and in 3D.
class ToolsFeature final : public Feature {
 public:
  /// `histogram` counts the values of the open case's CT.
  ToolsFeature(PrepareModel& model, PrepareLayout& layout, ui::HistogramEditor& histogram);

  ToolSession& tools() { return *tools_; }
  /// The section of the selected tool.
  Section& section() { return *section_; }

 private:
  void addChoosing();
  void addActing();
  void addBrush();

  ToolSession* tools_;
  Section* section_;
};

}  // namespace insonate::prepare
