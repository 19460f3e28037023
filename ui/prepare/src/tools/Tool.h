#pragma once

#include <insonate/segmentation/LabelStep.h>
#include <insonate/ui/ValueSlider.h>

#include <QString>
#include <QStringList>
#include <functional>
#include <optional>
#include <vector>

namespace insonate::prepare {

/// A numeric parameter of a tool.
struct ToolNumber {
  QString id, name, unit;
  ui::ValueRange range;
  QString hint;
  std::function<double(const LabelTool&)> get;
  std::function<void(LabelTool&, double)> set;
  bool ofVoxels = false;    ///< true: the range depends on the CT's voxel size and extent
  bool fromAVoxel = false;  ///< true: the range begins at the smallest voxel size, below which the number has no
                            ///< effect
};

/// The range of Hounsfield units that a tool uses.
struct ToolRange {
  std::function<HuRange(const LabelTool&)> get;
  std::function<void(LabelTool&, HuRange)> set;
};

/// A second label that a tool uses.
struct ToolLabel {
  QString name, hint;
  std::function<std::uint8_t(const LabelTool&)> get;
  std::function<void(LabelTool&, std::uint8_t)> set;
};

/// A parameter of a tool with a few named options.
struct ToolChoice {
  QString id, name;
  QStringList words;
  QString hint;
  std::function<int(const LabelTool&)> get;
  std::function<void(LabelTool&, int)> set;
};

/// Effect of the mouse on a slice while a tool is selected.
enum class ToolInput {
  Nothing,
  Brush,    ///< a left drag paints at once
  Outline,  ///< a left drag, or clicks, draw an outline
  Stroke,   ///< a left drag draws a stroke in place of the former stroke
  Points,   ///< clicks set points; a right click removes the nearest point
  Range     ///< a click sets the range around the clicked Hounsfield value
};

/// A tool in the window: an entry of LabelTool in the segmentation module. Two tools can use the same entry and differ
/// in what they write.
struct Tool {
  QString id, name;
  QString group;  ///< group of the tool; tools of one group share a button in the palette
  int key = 0;    ///< key of the tool's group: Qt::Key; 0: no key
  ToolInput input = ToolInput::Nothing;
  QString advice;  ///< instructions in one or two sentences
  LabelTool usual;
  std::vector<ToolNumber> numbers{};
  std::vector<ToolChoice> choices{};
  std::optional<ToolRange> range{};
  std::optional<ToolLabel> other{};
  int minPoints = 0;
  bool erases = false;  ///< true: the tool removes the painted voxels from the label
};

/// All tools, in the palette's order.
const std::vector<Tool>& toolTable();

/// Returns the clicked points of a tool; null if it uses none.
std::vector<Vec3>* pointsOf(LabelTool& tool);

}  // namespace insonate::prepare
