#pragma once

#include <insonate/core/Result.h>
#include <insonate/views/Theme.h>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace insonate::views {

/// A node of a transfer function.
struct TransferNode {
  double hu = 0;       ///< Hounsfield units, kMin_HU to kMax_HU
  double opacity = 0;  ///< opacity of a layer of one millimeter with this Hounsfield value, 0 to 1
  Color color{255, 255, 255};
  bool operator==(const TransferNode&) const = default;
};

/// Maps a CT's Hounsfield units to opacity and color, linear between nodes and constant beyond the first and the last
/// node. The function is plain data, which the view uses for drawing, and the editor for editing.
struct TransferFunction {
  static constexpr double kMin_HU = -1024, kMax_HU = 3071;
  static constexpr int kMaxNodes = 32;
  /// Minimum distance between two nodes, in HU.
  static constexpr double kMinGap_HU = 1;

  std::vector<TransferNode> nodes;  ///< nodes in increasing order of HU
  bool operator==(const TransferFunction&) const = default;

  /// Returns the opacity for a Hounsfield value; 0 if there are no nodes.
  double opacityAt(double hu) const;
  /// Returns the color for a Hounsfield value; black if there are no nodes.
  Color colorAt(double hu) const;
};

/// Returns the function with its nodes sorted, clamped to their ranges and separated by the minimum distance. Nodes
/// beyond the maximum number, and those that are not finite, are removed.
TransferFunction sortedAndClamped(TransferFunction function);

struct TransferPreset {
  std::string_view name;
  TransferFunction function;
};

/// Returns the presets: bone, soft tissue, skin and bone, contrast-filled vessels, lung.
std::span<const TransferPreset> transferPresets();

/// Reads a function from {"nodes": [{"hu": 150, "opacity": 0.2, "colour": "#aa5530"}, ...]} and applies
/// sortedAndClamped(). Fails if the text is not JSON of this form.
Result<TransferFunction> readTransferFunction(std::string_view json);
std::string writeTransferFunction(const TransferFunction& function);

}  // namespace insonate::views
