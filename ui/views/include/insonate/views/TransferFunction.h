#pragma once

#include <insonate/core/Result.h>
#include <insonate/views/Theme.h>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace insonate::views {

/// A corner of a transfer function.
struct TransferNode {
  double hu = 0;       ///< Hounsfield units, kLeast_HU..kMost_HU
  double opacity = 0;  ///< of one millimeter of such tissue, 0..1
  Colour colour{255, 255, 255};
  bool operator==(const TransferNode&) const = default;
};

/// Opacity and color of a CT's Hounsfield units, linear between nodes and constant beyond the first and the last.
/// Plain data, the same for the view that draws with it and the editor that changes it.
struct TransferFunction {
  static constexpr double kLeast_HU = -1024, kMost_HU = 3071;
  static constexpr int kMostNodes = 32;
  /// Two nodes are at least so far from each other, in HU.
  static constexpr double kLeastGap_HU = 1;

  std::vector<TransferNode> nodes;  ///< by rising HU
  bool operator==(const TransferFunction&) const = default;

  /// 0 without nodes.
  double opacityAt(double hu) const;
  /// Black without nodes.
  Colour colourAt(double hu) const;
};

/// Returns the nodes in order, within their ranges, apart by the minimum gap, and up to the maximum number; non-finite
/// ones are removed.
TransferFunction tidied(TransferFunction function);

struct TransferPreset {
  std::string_view name;
  TransferFunction function;
};

/// Bone first, then soft tissue, skin and bone, contrast vessels, lung.
std::span<const TransferPreset> transferPresets();

/// {"nodes": [{"hu": 150, "opacity": 0.2, "colour": "#aa5530"}, ...]}; tidied. Refuses text that is not such JSON.
Result<TransferFunction> readTransferFunction(std::string_view json);
std::string writeTransferFunction(const TransferFunction& function);

}  // namespace insonate::views
