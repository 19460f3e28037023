#include "Tool.h"

#include <insonate/ui/Text.h>

#include <array>
#include <utility>

namespace insonate::prepare {
namespace {

/// `field` returns a reference to the number in the tool's parameters.
template <class Step, class Field>
ToolNumber number(const char* id, const char* name, const char* unit, ui::ValueRange range, const char* hint,
                  Field field) {
  return {id,
          tr(name),
          tr(unit),
          range,
          tr(hint),
          [field](const LabelTool& tool) { return double(field(std::get<Step>(tool))); },
          [field](LabelTool& tool, double value) {
            auto& place = field(std::get<Step>(tool));
            place = std::remove_reference_t<decltype(place)>(value);
          }};
}

/// Words in the order of an enumeration.
template <class Step, class Field>
ToolChoice choice(const char* id, const char* name, QStringList words, const char* hint, Field field) {
  return {id,
          tr(name),
          std::move(words),
          tr(hint),
          [field](const LabelTool& tool) { return int(field(std::get<Step>(tool))); },
          [field](LabelTool& tool, int index) {
            auto& place = field(std::get<Step>(tool));
            place = std::remove_reference_t<decltype(place)>(index);
          }};
}

constexpr ui::ValueRange kBlur{0, 3, 0, 0.1, 1}, kRadius{0.3, 20, 0, 0.1, 1}, kEdge{1, 500, 0, 5, 0};

template <class Step>
ToolRange range() {
  return {[](const LabelTool& tool) { return std::get<Step>(tool).range_HU; },
          [](LabelTool& tool, HuRange value) { std::get<Step>(tool).range_HU = value; }};
}

/// Default: blood with contrast agent.
constexpr HuRange kUsualRange{150, 600};

Tool brush(const char* id, const char* name, int key, const char* advice, bool erases) {
  using S = step::Paint;
  ToolNumber radius = number<S>(
      "radius", "radius", "mm", {0.3, 40, 0, 0.5, 1}, "Radius of the brush (+ and -, [ and ], or Shift and the wheel)",
      [](auto& s) -> auto& { return s.radius_mm; });
  radius.ofVoxels = true;
  return {.id = id,
          .name = tr(name),
          .group = {},
          .key = key,
          .input = ToolInput::Brush,
          .advice = tr(advice),
          .usual = S{.sliceAxis = 2},
          .numbers = {radius},
          .choices = {{QStringLiteral("shape"),
                       tr("shape"),
                       {tr("circle in the slice"), tr("sphere")},
                       tr("Shape of the brush"),
                       [](const LabelTool& t) { return std::get<S>(t).sliceAxis ? 0 : 1; },
                       [](LabelTool& t, int n) {
                         auto& axis = std::get<S>(t).sliceAxis;
                         n == 0 ? axis.emplace(2) : (axis.reset(), 0);
                       }}},
          .erases = erases};
}

Tool scissors(const char* id, const char* name, const char* advice, bool erases) {
  using S = step::Scissors;
  return {.id = id,
          .name = tr(name),
          .group = tr("Scissors"),
          .key = Qt::Key_4,
          .input = ToolInput::Outline,
          .advice = tr(advice),
          .usual = S{},
          .numbers = {number<S>(
              "depth", "cut depth", "mm", {0, 300, 0, 5, 0},
              "Depth of the cut below the surface at the first corner of the outline, or to either side of a slice; 0: "
              "no limit",
              [](auto& s) -> auto& { return s.view.depth_mm; })},
          .choices = {choice<S>(
              "take", "part", {tr("inside"), tr("outside")},
              "Part to which the tool applies: inside or outside the outline",
              [](auto& s) -> auto& { return s.view.outside; })},
          .minPoints = 3,
          .erases = erases};
}

std::vector<Tool> drawing() {
  return {
      brush("paint", "Paint", Qt::Key_1, "Drag on a slice to paint the label.", false),
      brush("erase", "Erase", Qt::Key_2, "Drag on a slice to erase; only the selected label is erased.", true),
      {.id = "draw",
       .name = tr("Draw"),
       .group = {},
       .key = Qt::Key_3,
       .input = ToolInput::Outline,
       .advice = tr("Drag around the structure on a slice, or click points around it; Enter fills the outline."),
       .usual = step::Draw{},
       .minPoints = 3},
      scissors(
          "cut", "Cut",
          "Draw an outline on a slice or in 3D. Enter removes the label inside the outline, along the view direction.",
          true),
      scissors(
          "scissors", "Fill",
          "Draw an outline on a slice or in 3D. Enter labels everything inside the outline, along the view direction.",
          false),
      {.id = "cutoff",
       .name = tr("Remove leak"),
       .group = tr("Scissors"),
       .key = Qt::Key_4,
       .input = ToolInput::Stroke,
       .advice = tr("Drag a stroke across the neck of a leak on a slice; Enter removes the part of the label behind "
                    "the stroke."),
       .usual = step::CutOff{},
       .minPoints = 2}};
}

std::vector<Tool> growing() {
  using F = step::March;
  using L = step::Contour;
  using C = step::ConfidenceConnected;
  const QString group = tr("Grow");
  const auto edge = [](auto& s) -> auto& {
    return s.front.edge_HUpmm;
  };
  return {{.id = "connected",
           .name = tr("Connected"),
           .group = group,
           .key = Qt::Key_6,
           .input = ToolInput::Points,
           .advice = tr("Click in the structure; connected voxels whose CT values are in the range get the label."),
           .usual = step::Connected{{}, kUsualRange},
           .range = range<step::Connected>(),
           .minPoints = 1},
          {.id = "confidence",
           .name = tr("Confidence"),
           .group = group,
           .key = Qt::Key_6,
           .input = ToolInput::Points,
           .advice = tr("Click in the structure; the CT values around the clicks determine the range that is labeled."),
           .usual = C{},
           .numbers = {number<C>(
                           "spread", "range half-width", "SD", {0.5, 10, 0, 0.1, 1},
                           "Half the width of the labeled range around the mean CT value of the samples, in standard "
                           "deviations (SD)",
                           [](auto& s) -> auto& { return s.confidence.deviations; }),
                       number<C>(
                           "seed", "sample radius", "mm", {0.5, 20, 0, 0.5, 1},
                           "Radius around each click in which CT values are sampled",
                           [](auto& s) -> auto& { return s.confidence.seed_mm; })},
           .minPoints = 1},
          {.id = "seeds",
           .name = tr("From seeds"),
           .group = group,
           .key = Qt::Key_6,
           .input = ToolInput::Nothing,
           .advice = tr("Paint a little of each structure first; all visible, unlocked labels then grow into the space "
                        "between them."),
           .usual = step::GrowSeeds{},
           .numbers = {number<step::GrowSeeds>(
               "blur", "blur", "mm", kBlur, "Blur of the CT before the computation",
               [](auto& s) -> auto& { return s.competition.smoothing_mm; })}},
          {.id = "watershed",
           .name = tr("Watershed"),
           .group = group,
           .key = Qt::Key_6,
           .input = ToolInput::Nothing,
           .advice = tr("Paint a little of each structure first; borders are placed where CT values change most."),
           .usual = step::Watershed{},
           .numbers = {number<step::Watershed>(
               "blur", "blur", "mm", kBlur, "Blur of the CT before the computation",
               [](auto& s) -> auto& { return s.smoothing_mm; })}},
          {.id = "march",
           .name = tr("Fast marching"),
           .group = group,
           .key = Qt::Key_6,
           .input = ToolInput::Points,
           .advice = tr("Click in the structure; the label grows from the clicks until it meets edges in the CT."),
           .usual = F{},
           .numbers = {number<F>(
                           "reach", "maximum distance", "mm", {1, 60, 0, 1, 0}, "Maximum distance from the clicks",
                           [](auto& s) -> auto& { return s.front.reach_mm; }),
                       number<F>("edge", "edge steepness", "HU/mm", kEdge,
                                 "Steepness of an edge in the CT at which the label grows half as fast", edge)},
           .minPoints = 1},
          {.id = "levelset",
           .name = tr("Level set"),
           .group = group,
           .key = Qt::Key_6,
           .input = ToolInput::Nothing,
           .advice = tr("Moves the surface of the label to edges in the CT."),
           .usual = L{},
           .numbers = {number<L>(
                           "edge", "edge steepness", "HU/mm", kEdge,
                           "Steepness of an edge in the CT at which the label grows half as fast",
                           [](auto& s) -> auto& { return s.levelSet.edge_HUpmm; }),
                       number<L>(
                           "outward", "growth", "", {-3, 3, 0, 0.1, 1},
                           "Strength of growth; a negative value shrinks the label",
                           [](auto& s) -> auto& { return s.levelSet.propagation; }),
                       number<L>(
                           "smoothness", "smoothing", "", {0, 3, 0, 0.1, 1}, "Strength of smoothing",
                           [](auto& s) -> auto& { return s.levelSet.curvature; }),
                       number<L>(
                           "rounds", "maximum rounds", "", {1, 1000, 0, 10, 0},
                           "Maximum number of rounds of the computation, which stops earlier if the surface is stable",
                           [](auto& s) -> auto& { return s.levelSet.rounds; })}}};
}

std::vector<Tool> vessels() {
  using V = step::Vessel;
  using T = step::Tube;
  const QString group = tr("Vessel");
  return {
      {.id = "vessel",
       .name = tr("Vessel with contrast"),
       .group = group,
       .key = Qt::Key_7,
       .input = ToolInput::Points,
       .advice = tr("Click along a vessel with contrast agent, from one end to the other, on any slices."),
       .usual = V{},
       .numbers = {number<V>(
                       "largest", "maximum radius", "mm", {2, 30, 0, 0.5, 1},
                       "Maximum distance of the wall from the center line",
                       [](auto& s) -> auto& { return s.tracking.largest_mm; }),
                   number<V>(
                       "blur", "blur", "mm", kBlur, "Blur of the CT before the computation",
                       [](auto& s) -> auto& { return s.tracking.smoothing_mm; })},
       .minPoints = 2},
      {.id = "tube",
       .name = tr("Vessel without contrast"),
       .group = group,
       .key = Qt::Key_7,
       .input = ToolInput::Points,
       .advice = tr("Click along the middle of a vessel or muscle that differs little from its surroundings, from "
                    "one end to the other."),
       .usual = T{},
       .numbers = {number<T>(
                       "largest", "maximum radius", "mm", {2, 30, 0, 0.5, 1},
                       "Maximum distance of the wall from the center line",
                       [](auto& s) -> auto& { return s.tracking.largest_mm; }),
                   number<T>(
                       "darker", "lower tolerance", "HU", kEdge,
                       "Maximum difference by which a voxel may be darker than the middle of the structure",
                       [](auto& s) -> auto& { return s.tracking.darker_HU; }),
                   number<T>(
                       "brighter", "upper tolerance", "HU", kEdge,
                       "Maximum difference by which a voxel may be brighter than the middle of the structure",
                       [](auto& s) -> auto& { return s.tracking.brighter_HU; }),
                   number<T>(
                       "stiffness", "stiffness", "", {0, 10, 0, 0.1, 1}, "Resistance of the outline to dents and bumps",
                       [](auto& s) -> auto& { return s.tracking.stiffness; })},
       .minPoints = 2}};
}

template <class Step>
Tool smoothing(const char* id, const char* name, const char* advice, ToolNumber number) {
  return {.id = id,
          .name = tr(name),
          .group = tr("Smooth"),
          .key = Qt::Key_8,
          .advice = tr(advice),
          .usual = Step{},
          .numbers = {std::move(number)}};
}

/// 3D Slicer uses the full width, its kernel size.
template <class Step>
Tool smoothingInReach(const char* id, const char* name, const char* advice, const char* hint) {
  ToolNumber radius = number<Step>(
      "radius", "radius", "mm", kRadius, hint, [](auto& s) -> auto& { return s.radius_mm; });
  radius.fromAVoxel = true;
  return smoothing<Step>(id, name, advice, std::move(radius));
}

template <class Step>
Tool blurring(const char* id, const char* name, const char* advice) {
  return smoothing<Step>(
      id, name, advice,
      number<Step>(
          "sigma", "standard deviation", "mm", kRadius, "Standard deviation of the blur; smaller details vanish",
          [](auto& s) -> auto& { return s.sigma_mm; }));
}

std::vector<Tool> shaping() {
  using I = step::KeepLargest;
  using R = step::RemoveSmall;
  using M = step::Margin;
  using H = step::Hollow;
  const QString islands = tr("Islands"), shape = tr("Shape");
  return {
      smoothingInReach<step::Median>(
          "median", "Median", "Removes bumps and fills dents of the label.",
          "Radius of the block of voxels around each voxel; half of the kernel size in 3D Slicer"),
      smoothingInReach<step::Opening>(
          "opening", "Opening", "Removes thin bridges and spikes of the label.",
          "Removes parts narrower than twice this radius; half of the kernel size in 3D Slicer"),
      smoothingInReach<step::Closing>(
          "closing", "Closing", "Fills gaps and pits in the label.",
          "Fills gaps narrower than twice this radius; half of the kernel size in 3D Slicer"),
      blurring<step::Gaussian>("gaussian", "Gaussian", "Rounds edges and corners of the label."),
      blurring<step::SmoothTogether>("joint", "Smooth together",
                                     "Smooths all visible, unlocked labels without gaps between them."),
      {.id = "largest",
       .name = tr("Keep largest parts"),
       .group = islands,
       .key = Qt::Key_9,
       .advice = tr("Keeps the largest parts of the label; the other parts get the label of their surroundings."),
       .usual = I{},
       .numbers = {number<I>(
           "parts", "parts to keep", "", {1, 50, 0, 1, 0}, "Number of parts to keep",
           [](auto& s) -> auto& { return s.islands; })}},
      {.id = "small",
       .name = tr("Remove small parts"),
       .group = islands,
       .key = Qt::Key_9,
       .advice = tr("Parts of the label below a minimum volume get the label of their surroundings."),
       .usual = R{},
       .numbers = {number<R>(
           "least", "minimum volume", "mm\u00b3", {1, 10000, 0, 10, 0}, "Minimum volume of parts to keep",
           [](auto& s) -> auto& { return s.min_mm3; })}},
      {.id = "island",
       .name = tr("Keep clicked part"),
       .group = islands,
       .key = Qt::Key_9,
       .input = ToolInput::Points,
       .advice = tr(
           "Click the part of the label that you want to keep; the other parts get the label of their surroundings."),
       .usual = step::KeepIsland{},
       .minPoints = 1},
      {.id = "margin",
       .name = tr("Margin"),
       .group = shape,
       .key = Qt::Key_0,
       .advice = tr("Expands the label on all sides; a negative margin shrinks the label."),
       .usual = M{},
       .numbers = {number<M>(
           "margin", "margin", "mm", {-20, 20, 0, 0.5, 1},
           "Distance from the present surface to the new surface; a negative distance shrinks the label",
           [](auto& s) -> auto& { return s.margin_mm; })}},
      {.id = "hollow",
       .name = tr("Hollow"),
       .group = shape,
       .key = Qt::Key_0,
       .advice = tr("Keeps only a wall along the surface of the label."),
       .usual = H{},
       .numbers = {number<H>(
           "wall", "wall thickness", "mm", kRadius, "Thickness of the wall",
           [](auto& s) -> auto& { return s.thickness_mm; })},
       .choices = {choice<H>(
           "lies", "wall position", {tr("inside"), tr("centered on the surface"), tr("outside")},
           "Position of the wall relative to the surface", [](auto& s) -> auto& { return s.wall; })}},
      {.id = "logical",
       .name = tr("Combine"),
       .group = shape,
       .key = Qt::Key_0,
       .advice = tr("Combines the label with another label: adds the other label, removes voxels near it, or keeps "
                    "only voxels near it."),
       .usual = step::Logical{LogicalOperation::kAdd, 0},
       .numbers = {number<step::Logical>(
           "reach", "margin", "mm", {0, 20, 0, 0.5, 1},
           "Margin by which the other label is enlarged for this operation",
           [](auto& s) -> auto& { return s.reach_mm; })},
       .choices = {choice<step::Logical>(
           "do", "operation", {tr("add"), tr("subtract"), tr("intersect")},
           "Operation that combines the selected label with the other label",
           [](auto& s) -> auto& { return s.operation; })},
       .other = ToolLabel{tr("other label"), tr("Label to combine with the selected label"),
                          [](const LabelTool& t) { return std::get<step::Logical>(t).with; },
                          [](LabelTool& t, std::uint8_t label) { std::get<step::Logical>(t).with = label; }}},
      {.id = "fill",
       .name = tr("Fill between slices"),
       .group = shape,
       .key = Qt::Key_0,
       .advice =
           tr("Interpolates the label between the slices on which it was drawn, in the slice orientation used last."),
       .usual = step::FillBetween{}}};
}

std::vector<Tool> all() {
  std::vector<Tool> tools = drawing();
  tools.push_back({.id = "threshold",
                   .name = tr("Threshold"),
                   .group = {},
                   .key = Qt::Key_5,
                   .input = ToolInput::Range,
                   .advice = tr("Labels every voxel in the range. Click a slice to sample its value."),
                   .usual = step::Threshold{kUsualRange},
                   .range = range<step::Threshold>()});
  for (auto part : {growing(), vessels(), shaping()}) tools.insert(tools.end(), part.begin(), part.end());
  // Reset restores the defaults of the tool.
  for (Tool& tool : tools)
    for (ToolNumber& one : tool.numbers) one.range.defaultValue = one.get(tool.usual);
  return tools;
}

}  // namespace

const std::vector<Tool>& toolTable() {
  static const std::vector<Tool> table = all();
  return table;
}

std::vector<Vec3>* pointsOf(LabelTool& tool) {
  return std::visit(
      [](auto& step) -> std::vector<Vec3>* {
        if constexpr (requires { step.points_mm; })
          return &step.points_mm;
        else if constexpr (requires { step.stroke.points_mm; })
          return &step.stroke.points_mm;
        else
          return nullptr;
      },
      tool);
}

}  // namespace insonate::prepare
