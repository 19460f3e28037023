#pragma once

#include <insonate/ultrasound/ImagingSettings.h>

#include <vector>

namespace insonate {

/// The beam's two-way field across its axis, by depth, of a probe with these settings: the RMS amplitude over the
/// pulse's band of a point's echo, over that of a point on the axis.
///
/// Each element is a line source of the imaging plane or, across it, the element's height is a row of them; their waves
/// exp(i k (r - delay)) / sqrt(r) are summed by frequency in homogeneous tissue, as Garcia, Comput Methods Programs
/// Biomed 2022; 218:106726 does in three dimensions. Transmit focuses at focus_mm, receive at each depth with an
/// aperture that grows as depth over receiveFNumber up to maxAperture_mm, the lens at elevationFocus_mm.
/// tests/conformance/FieldTest.cpp holds images against that program's figures.
class BeamField {
 public:
  BeamField(const Probe& probe, const ImagingSettings& settings);

  /// Offsets of either sign; 0 far off the axis. Ranges beyond the image are those of its ends.
  double lateral(double off_mm, double range_mm) const { return across(lateral_, off_mm, range_mm); }
  double elevation(double off_mm, double range_mm) const { return across(elevation_, off_mm, range_mm); }

  /// Integral of elevation() over all offsets.
  double sliceIntegral_mm(double range_mm) const;
  /// SD of the Gaussian whose square is as wide as the slice's: sqrt(2) times the RMS offset, weighted by power.
  double sliceSd_mm(double range_mm) const;
  /// Offset beyond which elevation() is 0.
  double sliceReach_mm() const;

 private:
  /// Profiles at the nodes' depths, from the axis outward, in steps that grow with the beam.
  struct Profiles {
    int entries = 0;
    std::vector<double> step_mm;  ///< [node]
    std::vector<float> value;     ///< [node][entry]
  };
  struct Place {
    int node;
    double fraction;
  };
  void sumLateral(const Probe& probe, const ImagingSettings& settings);
  void sumElevation(const Probe& probe, const ImagingSettings& settings);
  Place placeOf(double range_mm) const;
  double node_mm(int node) const { return (node + 0.5) * spacing_mm_; }
  double across(const Profiles& profiles, double off_mm, double range_mm) const;

  double spacing_mm_;
  Profiles lateral_, elevation_;
  std::vector<double> sliceIntegral_mm_, sliceSd_mm_;  // [node]
};

}  // namespace insonate
