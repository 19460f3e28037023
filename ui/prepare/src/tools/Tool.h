#pragma once

#include <insonate/segmentation/LabelStep.h>
#include <insonate/ui/ValueSlider.h>

#include <QString>
#include <QStringList>
#include <functional>
#include <optional>
#include <vector>

namespace insonate::prepare {

/// A number of a tool.
struct ToolNumber {
  QString name, unit;
  ui::ValueRange range;
  QString hint;
  std::function<double(const LabelTool&)> get;
  std::function<void(LabelTool&, double)> set;
  bool ofVoxels = false;    ///< its range follows the CT's voxels and extent
  bool fromAVoxel = false;  ///< its range begins at the finest voxel: below, it does nothing
};

/// The Hounsfield units that a tool takes.
struct ToolRange {
  std::function<HuRange(const LabelTool&)> get;
  std::function<void(LabelTool&, HuRange)> set;
};

/// Another label that a tool needs.
struct ToolLabel {
  QString name, hint;
  std::function<std::uint8_t(const LabelTool&)> get;
  std::function<void(LabelTool&, std::uint8_t)> set;
};

/// One of a few words of a tool.
struct ToolChoice {
  QString name;
  QStringList words;
  QString hint;
  std::function<int(const LabelTool&)> get;
  std::function<void(LabelTool&, int)> set;
};

/// Action of the mouse on a slice while a tool is in hand.
enum class ToolInput {
  Nothing,
  Brush,    ///< a left drag writes at once
  Outline,  ///< a left drag, or clicks, draw an outline
  Points,   ///< clicks set points, a right click takes the nearest away
  Range     ///< a click takes the Hounsfield unit there
};

/// A tool of the window: an entry of segmentation's LabelTool, or two of them that differ in what they write.
struct Tool {
  QString id, name;
  QString group;  ///< tools of a group share a button of the palette
  int key = 0;    ///< Qt::Key of its group; 0 for none
  ToolInput input = ToolInput::Nothing;
  QString advice;  ///< what to do, a sentence or two
  LabelTool usual;
  std::vector<ToolNumber> numbers{};
  std::vector<ToolChoice> choices{};
  std::optional<ToolRange> range{};
  std::optional<ToolLabel> other{};
  int leastPoints = 0;
  bool erases = false;  ///< the label loses what is painted
};

/// All tools, in the palette's order.
const std::vector<Tool>& toolTable();

/// Clicked points of a tool; null if it takes none.
std::vector<Vec3>* pointsOf(LabelTool& tool);

}  // namespace insonate::prepare
