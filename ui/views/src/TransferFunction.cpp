#include <insonate/core/JsonEntry.h>
#include <insonate/views/TransferFunction.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>

namespace insonate::views {
namespace {

using Nodes = std::vector<TransferNode>;

/// The node before a value and its position between that node and the next; clamped to the ends. Requires nodes.
struct Between {
  std::size_t first, second;
  double share;
};

Between between(const Nodes& nodes, double hu) {
  const auto after =
      std::upper_bound(nodes.begin(), nodes.end(), hu, [](double value, const auto& node) { return value < node.hu; });
  if (after == nodes.begin()) return {0, 0, 0};
  const std::size_t first = std::size_t(after - nodes.begin()) - 1;
  if (after == nodes.end()) return {first, first, 0};
  return {first, first + 1, (hu - nodes[first].hu) / (after->hu - nodes[first].hu)};
}

std::uint8_t mixed(std::uint8_t a, std::uint8_t b, double share) {
  return static_cast<std::uint8_t>(std::lround(a + (double(b) - a) * share));
}

std::string hex(Color color) {
  char text[8];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", color.red, color.green, color.blue);
  return text;
}

std::optional<Color> fromHex(const std::string& text) {
  if (text.size() != 7 || text[0] != '#') return std::nullopt;
  unsigned value = 0;
  for (const char digit : text.substr(1)) {
    const bool number = digit >= '0' && digit <= '9', lower = digit >= 'a' && digit <= 'f';
    if (!number && !lower && !(digit >= 'A' && digit <= 'F')) return std::nullopt;
    value = value * 16 + unsigned(number ? digit - '0' : (digit | 0x20) - 'a' + 10);
  }
  return Color{std::uint8_t(value >> 16), std::uint8_t(value >> 8), std::uint8_t(value)};
}

TransferNode readNode(const nlohmann::json& object, const std::string& where, std::string& error) {
  constexpr double kUnbounded = 1e9;  // sortedAndClamped() limits both
  JsonEntry entry(object, where, {"hu", "opacity", "colour"}, error);
  const double hu = entry.number("hu", -kUnbounded, kUnbounded);
  const double opacity = entry.number("opacity", -kUnbounded, kUnbounded);
  const auto color = fromHex(entry.text("colour"));
  if (!color) entry.setError("needs a color like \"#aa5530\" as 'colour'.");
  return {hu, opacity, color.value_or(Color{})};
}

}  // namespace

double TransferFunction::opacityAt(double hu) const {
  if (nodes.empty()) return 0;
  const Between at = between(nodes, hu);
  return nodes[at.first].opacity + (nodes[at.second].opacity - nodes[at.first].opacity) * at.share;
}

Color TransferFunction::colorAt(double hu) const {
  if (nodes.empty()) return {};
  const Between at = between(nodes, hu);
  const Color a = nodes[at.first].color, b = nodes[at.second].color;
  return {mixed(a.red, b.red, at.share), mixed(a.green, b.green, at.share), mixed(a.blue, b.blue, at.share)};
}

TransferFunction sortedAndClamped(TransferFunction function) {
  using F = TransferFunction;
  Nodes& nodes = function.nodes;
  std::erase_if(nodes,
                [](const TransferNode& node) { return !std::isfinite(node.hu) || !std::isfinite(node.opacity); });
  if (nodes.size() > F::kMaxNodes) nodes.resize(F::kMaxNodes);
  std::stable_sort(nodes.begin(), nodes.end(), [](const auto& a, const auto& b) { return a.hu < b.hu; });
  // Upward from the minimum, then back from the maximum: nodes that crowd at an end move inward.
  double least = F::kMin_HU;
  for (TransferNode& node : nodes) {
    node.hu = std::max(node.hu, least);
    node.opacity = std::clamp(node.opacity, 0.0, 1.0);
    least = node.hu + F::kMinGap_HU;
  }
  double most = F::kMax_HU;
  for (auto node = nodes.rbegin(); node != nodes.rend(); ++node) {
    node->hu = std::min(node->hu, most);
    most = node->hu - F::kMinGap_HU;
  }
  return function;
}

std::span<const TransferPreset> transferPresets() {
  static const std::array<TransferPreset, 5> kPresets{{
      {"bone",
       {{{150, 0, {140, 82, 61}},
         {250, 0.12, {199, 158, 117}},
         {500, 0.55, {235, 217, 184}},
         {1500, 0.9, {250, 245, 235}}}}},
      {"soft tissue",
       {{{-400, 0, {158, 107, 87}},
         {-150, 0.06, {179, 128, 105}},
         {-20, 0.1, {191, 115, 97}},
         {60, 0.25, {184, 84, 71}},
         {200, 0.35, {217, 184, 148}},
         {700, 0.8, {242, 235, 217}}}}},
      {"skin and bone",
       {{{-600, 0, {196, 148, 122}},
         {-450, 0.05, {196, 148, 122}},
         {-300, 0.05, {196, 148, 122}},
         {-150, 0, {196, 148, 122}},
         {220, 0, {214, 178, 134}},
         {450, 0.6, {235, 217, 184}},
         {1500, 0.95, {250, 245, 235}}}}},
      {"contrast vessels",
       {{{110, 0, {150, 30, 24}},
         {170, 0.35, {200, 52, 40}},
         {320, 0.6, {226, 96, 72}},
         {420, 0.12, {220, 190, 150}},
         {900, 0.3, {240, 230, 210}}}}},
      {"lung",
       {{{-980, 0, {60, 80, 110}},
         {-900, 0.02, {90, 130, 170}},
         {-750, 0.06, {150, 190, 210}},
         {-550, 0.12, {220, 200, 190}},
         {-400, 0, {220, 160, 140}},
         {300, 0, {230, 215, 190}},
         {700, 0.25, {240, 232, 214}}}}},
  }};
  return kPresets;
}

Result<TransferFunction> readTransferFunction(std::string_view text) {
  const std::string subject = "The transfer function";
  const auto document = parsedJson(text, subject);
  if (!document) return tl::unexpected(document.error());
  JsonEntry function(*document, subject, {"nodes"});
  Nodes nodes = function.list("nodes", "node", readNode);
  if (!function.has("nodes")) function.setError("has no 'nodes'.");
  if (!function.error().empty()) return fail(function.error());
  return sortedAndClamped({std::move(nodes)});
}

std::string writeTransferFunction(const TransferFunction& function) {
  nlohmann::ordered_json nodes = nlohmann::ordered_json::array();
  for (const TransferNode& node : function.nodes)
    nodes.push_back({{"hu", node.hu}, {"opacity", node.opacity}, {"colour", hex(node.color)}});
  return nlohmann::ordered_json{{"nodes", std::move(nodes)}}.dump();
}

}  // namespace insonate::views
