#include "reference/TissueLookup.h"

#include "model/Boundary.h"
#include "model/PlaneShift.h"
#include "scene/FieldSampling.h"

#include <algorithm>
#include <cmath>

namespace insonate {
namespace {

constexpr double kSteepest = 0.3;  // smaller gradients of smoothed distances are ridges between structures
constexpr double kLeastSlope = 1e-3;

double mix(double a, double b, double t) {
  return a + (b - a) * t;
}

}  // namespace

TissueLookup::TissueLookup(const FramePlan& plan, const AcousticScene::Impl& scene, const Transform& patientFromProbe,
                           const PlaneDisplacement& displacement)
    : plan_(plan), scene_(scene), patientFromProbe_(patientFromProbe), displacement_(displacement) {
  for (int column = 0; column < plan.nodeColumns; ++column) {
    const double line = column * plan.cellLines;
    contacts_.push_back(
        contactOf(scene.field, patientFromProbe, displacement, plan.grid.origin(line), plan.grid.direction(line)));
  }
  if (!displacement.empty())
    for (int row = 0; row < plan.nodeRows; ++row)
      for (int column = 0; column < plan.nodeColumns; ++column) shifts_.push_back(nodeShift(row, column));
  for (int plane = 0; plane < plan.settings.elevationPlanes; ++plane)
    for (int row = 0; row < plan.nodeRows; ++row)
      for (int column = 0; column < plan.nodeColumns; ++column) nodes_.push_back(nodeAt(plane, row, column));
}

Contact TissueLookup::contact(int line) const {
  const int column = line / plan_.cellLines;
  const double t = double(line - column * plan_.cellLines) / plan_.cellLines;
  const Contact &a = contacts_[column], &b = contacts_[column + 1];
  return {plan_.settings.conformingContact ? mix(a.gap_mm, b.gap_mm, t) : 0, mix(a.strength, b.strength, t)};
}

/// In the probe frame.
Vec3 TissueLookup::seenPoint(int plane, double gate, double line, double gap_mm) const {
  const double range_mm = plan_.range_mm(gate);
  const int g = std::clamp(static_cast<int>(gate), 0, plan_.gates - 1);
  const double elevation_mm = plan_.planeOffset_sd[plane] * plan_.elevationSd_mm[g];
  return plan_.grid.origin(line) + plan_.grid.direction(line) * tissueRange_mm(range_mm, gap_mm) +
         Vec3{0, elevation_mm, 0};
}

Vec3 TissueLookup::nodeShift(int row, int column) const {
  const double gap_mm = plan_.settings.conformingContact ? contacts_[column].gap_mm : 0;
  const Vec3 seen = seenPoint(0, row * plan_.cellGates, column * plan_.cellLines, gap_mm);
  return shiftAt(displacement_, seen.x, seen.z);
}

/// Interpolated between the nodes of its cell.
Vec3 TissueLookup::gateShift(int gate, int line) const {
  if (shifts_.empty()) return {};
  const int row = gate / plan_.cellGates, column = line / plan_.cellLines;
  const double down = double(gate - row * plan_.cellGates) / plan_.cellGates;
  const double across = double(line - column * plan_.cellLines) / plan_.cellLines;
  const Vec3* top = shifts_.data() + std::size_t(row) * plan_.nodeColumns + column;
  const Vec3* bottom = top + plan_.nodeColumns;
  const auto along = [&](const Vec3* left) { return left[0] + across * (left[1] - left[0]); };
  return along(top) + down * (along(bottom) - along(top));
}

const TissueLookup::Node& TissueLookup::node(int plane, int row, int column) const {
  return nodes_[(std::size_t(plane) * plan_.nodeRows + row) * plan_.nodeColumns + column];
}

TissueLookup::Node TissueLookup::nodeAt(int plane, int row, int column) const {
  const double gap = plan_.settings.conformingContact ? contacts_[column].gap_mm : 0;
  const Vec3 seen = seenPoint(plane, row * plan_.cellGates, column * plan_.cellLines, gap);
  const Vec3 shift = shifts_.empty() ? Vec3{} : shifts_[std::size_t(row) * plan_.nodeColumns + column];
  const Vec3 patient = patientFromProbe_ * (seen + shift);
  const TissueField& field = scene_.field;
  const FieldCell at = cellAt(field, field.nodeFromPatient * patient);
  Node n;
  // Tissue beyond the scene has the values at the scene's border.
  n.inside =
      at.inside || (!shifts_.empty() && cellAt(field, field.nodeFromPatient * (patientFromProbe_ * seen)).inside);
  for (int corner = 0; corner < 8; ++corner) {
    for (int c = 0; c < field.channels; ++c)
      n.distance_mm[c] += at.weight[corner] * field.distance[at.offset[corner]].to[c] / TissueField::kUnitsPerMm;
    n.ctDeviation += at.weight[corner] * field.ctDeviation[at.offset[corner]];
  }
  const TextureTile& patches = patchTile();
  const Vec3 voxel = (patient - scene_.textureOrigin_mm) / patches.voxel_mm.x;
  n.patch = patches.between(voxel) / 32;
  n.wander_mm = kLayerWander_mm * patches.between(voxel + kWanderStep_voxels * Vec3{1, 1, 1}) / 32;
  return n;
}

TissueLookup::Cell TissueLookup::cellOf(int plane, int row, int column) const {
  const Node* corner[4] = {&node(plane, row, column), &node(plane, row, column + 1), &node(plane, row + 1, column),
                           &node(plane, row + 1, column + 1)};
  Cell cell;
  double nearest = 1e30, second = 1e30;
  for (int c = 0; c < scene_.field.channels; ++c) {
    double sum = 0;
    for (const Node* n : corner) sum += n->distance_mm[c];
    if (sum < nearest) {
      second = nearest, cell.b = cell.a;
      nearest = sum, cell.a = c;
    } else if (sum < second) {
      second = sum, cell.b = c;
    }
  }
  if (scene_.field.channels == 1) cell.b = cell.a;
  for (int q = 0; q < 4; ++q) {
    cell.s[q] = cell.a == cell.b ? TissueField::kReach_mm
                                 : (corner[q]->distance_mm[cell.b] - corner[q]->distance_mm[cell.a]) / 2;
    cell.ctDeviation += corner[q]->ctDeviation / 4;
    cell.patch[q] = corner[q]->patch;
    cell.wander_mm[q] = corner[q]->wander_mm;
    cell.inside = cell.inside && corner[q]->inside;
  }
  const double range_mm = plan_.range_mm((row + 0.5) * plan_.cellGates);
  const double axial = (cell.s[2] - cell.s[0] + cell.s[3] - cell.s[1]) / 2 / (plan_.cellGates * plan_.gate_mm);
  const double lateral =
      (cell.s[1] - cell.s[0] + cell.s[3] - cell.s[2]) / 2 / (plan_.cellLines * plan_.grid.scanlineSpacing_mm(range_mm));
  const double elevation = elevationSlope(plane, row, column, cell, axial, lateral);
  const double gradient = std::hypot(std::hypot(axial, lateral), elevation);
  cell.cosine = std::min(1.0, std::abs(axial) / std::max(gradient, kSteepest));
  const int gate = std::min(row * plan_.cellGates, plan_.gates - 1);
  cell.spread_mm = std::hypot(lateral * plan_.grid.scanlineSpacing_mm(range_mm),
                              elevation * plan_.planeSpacing_sd * plan_.elevationSd_mm[gate]) /
                   std::max(std::abs(axial), kLeastSlope);
  return cell;
}

/// Slope of a distance at rest in the plane, from its slopes in displaced tissue, which are the transposed derivative
/// of the rest point, in beam coordinates, times that of the distance.
double TissueLookup::inPlaneSlopeAtRest(int row, int column, double axial, double lateral) const {
  if (shifts_.empty()) return std::hypot(axial, lateral);
  const Vec3* top = shifts_.data() + std::size_t(row) * plan_.nodeColumns + column;
  const Vec3* bottom = top + plan_.nodeColumns;
  const double range_mm = plan_.range_mm((row + 0.5) * plan_.cellGates);
  const Vec3 byAxial = (bottom[0] - top[0] + bottom[1] - top[1]) / (2 * plan_.cellGates * plan_.gate_mm);
  const Vec3 byLateral =
      (top[1] - top[0] + bottom[1] - bottom[0]) / (2 * plan_.cellLines * plan_.grid.scanlineSpacing_mm(range_mm));
  const Vec3 beam = plan_.grid.direction(column * plan_.cellLines), side{beam.z, 0, -beam.x};
  const double aa = 1 + dot(beam, byAxial), la = dot(side, byAxial), al = dot(beam, byLateral),
               ll = 1 + dot(side, byLateral);
  return std::hypot(ll * axial - la * lateral, aa * lateral - al * axial) / std::max(aa * ll - la * al, kLeastVolume);
}

/// Change of s in elevation, from the neighboring planes. A single plane has none: the gradient of a distance at rest
/// is then assumed to be 1, and the elevation component is what its change in the plane leaves.
double TissueLookup::elevationSlope(int plane, int row, int column, const Cell& cell, double axial,
                                    double lateral) const {
  const int last = plan_.settings.elevationPlanes - 1;
  if (last == 0) {
    const double inPlane = inPlaneSlopeAtRest(row, column, axial, lateral);
    return std::sqrt(std::max(0.0, 1 - inPlane * inPlane));
  }
  const int low = std::max(plane - 1, 0), high = std::min(plane + 1, last);
  const int gate = std::min(row * plan_.cellGates, plan_.gates - 1);
  const double distance_mm = (plan_.planeOffset_sd[high] - plan_.planeOffset_sd[low]) * plan_.elevationSd_mm[gate];
  const auto s = [&](int p) {
    const Node& n = node(p, row, column);
    return (n.distance_mm[cell.b] - n.distance_mm[cell.a]) / 2;
  };
  return (s(high) - s(low)) / distance_mm;
}

TissueSample TissueLookup::at(int plane, int gate, int line) const {
  const int row = gate / plan_.cellGates, column = line / plan_.cellLines;
  const Cell cell = cellOf(plane, row, column);
  const double down = double(gate - row * plan_.cellGates) / plan_.cellGates;
  const double across = double(line - column * plan_.cellLines) / plan_.cellLines;

  TissueSample sample;
  sample.patient_mm = patientFromProbe_ * (seenPoint(plane, gate, line, contact(line).gap_mm) + gateShift(gate, line));
  sample.inside = cell.inside;
  const auto within = [&](const double(&corner)[4]) {
    return mix(mix(corner[0], corner[1], across), mix(corner[2], corner[3], across), down);
  };
  sample.s_mm = within(cell.s);
  const int channel = sample.s_mm >= 0 ? cell.a : cell.b;
  sample.label = scene_.field.label[channel];
  sample.outside = sample.label == kBackground && plan_.range_mm(gate) < acoustics::kContactReach_mm;
  sample.cell = row;
  sample.pair = cell.a * TissueField::kStride + cell.b;
  sample.cosine = cell.cosine;

  const AcousticTissue& tissue = scene_.table.of(sample.label);
  sample.impedance_MRayl =
      tissue.impedance_MRayl *
      (1 + (plan_.settings.effects.texture ? tissue.ctImpedancePer100HU * cell.ctDeviation / 100 : 0));
  const double patch = within(cell.patch);
  sample.patch = patch;
  sample.spread_mm = cell.spread_mm;
  const AcousticTissue &a = scene_.table.of(scene_.field.label[cell.a]),
                       &b = scene_.table.of(scene_.field.label[cell.b]);
  const bool vessel = (a.vessel || b.vessel) && !acousticallyEqual(a, b);
  sample.grazesVessel =
      vessel && std::abs(sample.s_mm) < acoustics::kEdgeReach_mm && cell.cosine < acoustics::kEdgeCosine;
  sample.echo_dB = tissue.echogenicity_dB;
  if (plan_.settings.effects.texture) addTexture(sample, cell, patientFromProbe_.linear * plan_.grid.direction(line));
  if (plan_.settings.effects.layers) addLayers(sample, cell, patch, within(cell.wander_mm));
  return sample;
}

void TissueLookup::addTexture(TissueSample& sample, const Cell& cell, Vec3 beam) const {
  const AcousticTissue& tissue = scene_.table.of(sample.label);
  const TextureFrame& frame = scene_.textureFrames[sample.label][sample.patient_mm.x < scene_.midline_mm ? 0 : 1];
  const TextureTile& tile = textureTile(tissue.texture);
  double value = tile.at(frame.tileFromPatient * sample.patient_mm) / 127.0;
  if (value > 0) {
    value *= sheetFacing(dot(beam, frame.thinAxis));
    if (hasSheets(tissue.texture)) sample.sheet = kSheetCoherence * value;
  }
  sample.echo_dB += tissue.ctEchogenicity_dBper100HU * cell.ctDeviation / 100 + tissue.textureStrength_dB * value;
}

void TissueLookup::addLayers(TissueSample& sample, const Cell& cell, double patch, double wander_mm) const {
  const int entry = static_cast<int>(std::floor((sample.s_mm + wander_mm) / BoundaryProfiles::kStep_mm)) +
                    BoundaryProfiles::kEntries / 2;
  if (entry < 0 || entry >= BoundaryProfiles::kEntries) return;
  const std::uint32_t e = scene_.profiles.entries()[scene_.profiles.first(cell.a, cell.b) + entry];
  const auto byte = [&](int n) { return (e >> (8 * n) & 255U) / 255.0; };
  const double occupancy = layerCover(byte(0), byte(3), patch);
  const double facing_dB = 20 * std::log10(0.12 + 0.88 * cell.cosine * cell.cosine);
  const double layer_dB = (e >> 8 & 255U) / 4.0 - 32 + byte(2) * facing_dB;
  sample.echo_dB += occupancy * (layer_dB - sample.echo_dB);
  sample.sheet += occupancy * (kSheetCoherence * byte(2) - sample.sheet);
}

int TissueLookup::firstGasGate(int line) const {
  const int central = plan_.settings.elevationPlanes / 2;
  bool tissueAbove = false;
  for (int gate = 0; gate < plan_.gates; ++gate) {
    const TissueSample sample = at(central, gate, line);
    if (!sample.inside) return -1;
    const bool gas = scene_.table.of(sample.label).gas && !sample.outside;
    if (gas && tissueAbove) return gate;
    tissueAbove = tissueAbove || !gas;
  }
  return -1;
}

}  // namespace insonate
