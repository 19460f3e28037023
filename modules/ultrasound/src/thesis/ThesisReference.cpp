#include "thesis/ThesisReference.h"

#include "model/Contact.h"
#include "model/PlaneShift.h"
#include "thesis/ThesisModel.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace insonate::thesis {
namespace {

double mix(double a, double b, double t) {
  return a + (b - a) * t;
}

SceneSample combined(const SceneSample& a, double wa, const SceneSample& b, double wb, int channels) {
  SceneSample sum;
  for (int c = 0; c < channels; ++c) sum.distance_mm[c] = wa * a.distance_mm[c] + wb * b.distance_mm[c];
  sum.ctDeviation_HU = wa * a.ctDeviation_HU + wb * b.ctDeviation_HU;
  sum.beyond = wa * a.beyond + wb * b.beyond;
  return sum;
}

/// Tissue beyond the scene has the values at the scene's border.
SceneSample sampleDisplaced(const TissueField& field, const Transform& patientFromProbe, Vec3 seen, Vec3 shift) {
  SceneSample sample = sampleScene(field, patientFromProbe * (seen + shift));
  sample.beyond = std::min(sample.beyond, beyondLattice(field, field.nodeFromPatient * (patientFromProbe * seen)));
  return sample;
}

/// Medium and boundaries of all elevation planes on the map rows, and the contact of each scanline.
class SceneMap {
 public:
  SceneMap(const FramePlan& plan, const ThesisPlan& thesis, const AcousticScene::Impl& scene,
           const Transform& patientFromProbe, const PlaneDisplacement& displacement)
      : plan_(plan), mapRows_(thesis.mapRows) {
    for (int column = 0; column < plan.nodeColumns; ++column) {
      const double line = column * plan.cellLines;
      contacts_.push_back(
          contactOf(scene.field, patientFromProbe, displacement, plan.grid.origin(line), plan.grid.direction(line)));
    }
    for (int plane = 0; plane < plan.settings.elevationPlanes; ++plane) {
      std::vector<SceneSample> nodes;
      for (int row = 0; row < plan.nodeRows; ++row)
        for (int column = 0; column < plan.nodeColumns; ++column) {
          const Vec3 seen = nodeAt(plane, row, column);
          nodes.push_back(sampleDisplaced(scene.field, patientFromProbe, seen, shiftAt(displacement, seen.x, seen.z)));
        }
      addPlane(thesis, scene, nodes);
    }
  }

  double strength(int line) const {
    const int column = line / plan_.cellLines;
    return mix(contacts_[column].strength, contacts_[column + 1].strength, across(line));
  }

  MapSample at(int plane, int gate, int line) const {
    const double place = 2.0 * gate / plan_.cellGates;
    const int row = static_cast<int>(place), column = line / plan_.cellLines;
    const MapSample* m = map_.data() + (std::size_t(plane) * mapRows_ + row) * plan_.nodeColumns + column;
    const auto bilinear = [&](double MapSample::*value) {
      const MapSample* below = m + plan_.nodeColumns;
      return mix(mix(m[0].*value, m[1].*value, across(line)), mix(below[0].*value, below[1].*value, across(line)),
                 place - row);
    };
    return {bilinear(&MapSample::reflection), bilinear(&MapSample::loss_dBpmm), bilinear(&MapSample::echo)};
  }

 private:
  double across(int line) const { return double(line % plan_.cellLines) / plan_.cellLines; }

  /// In the probe's frame.
  Vec3 nodeAt(int plane, int row, int column) const {
    const double gap_mm = plan_.settings.conformingContact ? contacts_[column].gap_mm : 0;
    const int gate = row * plan_.cellGates, line = column * plan_.cellLines;
    const double elevation_mm = plan_.planeOffset_sd[plane] * plan_.elevationSd_mm[std::min(gate, plan_.gates - 1)];
    return plan_.grid.origin(line) + plan_.grid.direction(line) * tissueRange_mm(plan_.range_mm(gate), gap_mm) +
           Vec3{0, elevation_mm, 0};
  }

  void addPlane(const ThesisPlan& thesis, const AcousticScene::Impl& scene, const std::vector<SceneSample>& nodes) {
    const auto channels = channelAcoustics(plan_.settings, scene);
    const int last = plan_.nodeRows - 1;
    for (int row = 0; row < mapRows_; ++row) {
      // On a row of nodes, the slope is that between the rows before and after; midway between two rows, it is the
      // slope between them.
      const bool onNodes = row % 2 == 0;
      const int here = row / 2, next = onNodes ? here : here + 1;
      const int above = onNodes ? std::max(here - 1, 0) : here, below = onNodes ? std::min(here + 1, last) : next;
      for (int column = 0; column < plan_.nodeColumns; ++column) {
        const auto node = [&](int r) -> const SceneSample& {
          return nodes[std::size_t(r) * plan_.nodeColumns + column];
        };
        const SceneSample value = combined(node(here), 0.5, node(next), 0.5, scene.field.channels);
        const double perMm = 1 / ((below - above) * thesis.row_mm);
        const SceneSample slope = combined(node(below), perMm, node(above), -perMm, scene.field.channels);
        const double range_mm = plan_.range_mm(0) + row * thesis.mapRow_mm();
        map_.push_back(mapAt(value, slope, range_mm, thesis, plan_.settings, scene, channels));
      }
    }
  }

  const FramePlan& plan_;
  int mapRows_;
  std::vector<Contact> contacts_;  ///< [column]
  std::vector<MapSample> map_;     ///< [plane][row][column]
};

/// [gate][line]
class EchoMap {
 public:
  explicit EchoMap(const FramePlan& plan) : lines_(plan.lines), values_(std::size_t(plan.gates) * plan.lines) {}
  double& at(int gate, int line) { return values_[std::size_t(gate) * lines_ + line]; }
  double at(int gate, int line) const { return values_[std::size_t(gate) * lines_ + line]; }

 private:
  int lines_;
  std::vector<double> values_;
};

/// Reflection, absorption and speckle of one scanline, all elevation planes.
void traceLine(const FramePlan& plan, const ThesisPlan& thesis, const SceneMap& map, std::uint32_t seed, int line,
               EchoMap& echo) {
  for (int plane = 0; plane < plan.settings.elevationPlanes; ++plane) {
    double level_dB = 20 * std::log10(std::max(map.strength(line), 1e-9));
    for (int gate = 0; gate < plan.gates; ++gate) {
      const MapSample here = map.at(plane, gate, line);
      const double loss_dB = here.loss_dBpmm * plan.gate_mm;
      const double amplitude = plan.boundaryWeight[plane] * std::pow(10, (level_dB - loss_dB / 2) / 20);
      level_dB -= loss_dB;
      const double x = (line + 0.5) / plan.lines, y = plan.range_mm(gate) / plan.settings.depth_mm;
      const double speckle = plan.settings.effects.speckle ? speckleFactor(usnoise2d(x, y, thesis.noise, seed)) : 1;
      echo.at(gate, line) += amplitude * (here.echo * speckle + here.reflection);
    }
  }
}

/// Radial blur: an exponential tail along each scanline, and a lateral convolution. Beyond its sides, the image
/// continues unchanged.
EchoMap blurred(const FramePlan& plan, const ThesisPlan& thesis, EchoMap echo) {
  for (int line = 0; line < plan.lines; ++line)
    for (int gate = 1; gate < plan.gates; ++gate)
      echo.at(gate, line) = mix(echo.at(gate, line), echo.at(gate - 1, line), thesis.tailShare);
  EchoMap out(plan);
  for (int gate = 0; gate < plan.gates; ++gate) {
    const int radius = plan.lateralRadius[gate];
    const double* kernel = plan.lateralKernel.data() + std::size_t(gate) * (plan.maxLateralRadius + 1);
    for (int line = 0; line < plan.lines; ++line)
      for (int o = -radius; o <= radius; ++o)
        out.at(gate, line) += kernel[std::abs(o)] * echo.at(gate, std::clamp(line + o, 0, plan.lines - 1));
  }
  return out;
}

}  // namespace

void renderReference(const FramePlan& plan, const AcousticScene::Impl& scene, const Transform& patientFromProbe,
                     const PlaneDisplacement& displacement, EnvelopeFrame& envelope) {
  const ThesisPlan thesis(plan);
  const SceneMap map(plan, thesis, scene, patientFromProbe, displacement);
  const std::uint32_t seed = noiseSeed(patientFromProbe, plan.settings.time_s);
  EchoMap echo(plan);
  for (int line = 0; line < plan.lines; ++line) traceLine(plan, thesis, map, seed, line, echo);
  const EchoMap blur = blurred(plan, thesis, std::move(echo));
  envelope.resize(plan.lines, plan.grid.samples(), 1);
  for (int m = 0; m < plan.grid.samples(); ++m) {
    const double gate = std::clamp((m + 0.5) / plan.stride - 0.5, 0.0, plan.gates - 1.0);
    const int before = std::min(static_cast<int>(gate), plan.gates - 1), after = std::min(before + 1, plan.gates - 1);
    for (int l = 0; l < plan.lines; ++l)
      envelope.look(0)[std::size_t(m) * plan.lines + l] =
          static_cast<float>(mix(blur.at(before, l), blur.at(after, l), gate - before));
  }
}

}  // namespace insonate::thesis
