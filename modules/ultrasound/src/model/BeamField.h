#pragma once

#include <insonate/ultrasound/ImagingSettings.h>

#include <vector>

namespace insonate {

/// The beam's two-way field perpendicular to its axis, by depth, of a probe with these settings. The value is the RMS
/// amplitude, over the pulse's band, of the echo of a point, divided by the RMS amplitude for a point on the axis.
///
/// In the imaging plane each element is a line source; in elevation, the element's height is a row of line sources.
/// Their waves exp(i k (r - delay)) / sqrt(r) are summed by frequency in homogeneous tissue, as Garcia, Comput Methods
/// Programs Biomed 2022; 218:106726 does in three dimensions. Transmission focuses at focus_mm. Reception focuses at
/// each depth, with an aperture of depth over receiveFNumber, at most maxAperture_mm. The lens focuses at
/// elevationFocus_mm. tests/conformance/FieldTest.cpp compares images with the results of Garcia's program.
class BeamField {
 public:
  BeamField(const Probe& probe, const ImagingSettings& settings);

  /// lateral() and elevation() return the field at an offset (of either sign) from the axis; 0 far from the axis. A
  /// range outside the image counts as the range of the nearest end of the image.
  double lateral(double off_mm, double range_mm) const { return across(lateral_, off_mm, range_mm); }
  double elevation(double off_mm, double range_mm) const { return across(elevation_, off_mm, range_mm); }

  /// Returns the integral of elevation() over all offsets at a depth, mm.
  double sliceIntegral_mm(double range_mm) const;
  /// Returns the SD of the Gaussian whose square is as wide as the squared elevation profile: sqrt(2) times the RMS
  /// offset, weighted by power.
  double sliceSd_mm(double range_mm) const;
  /// Returns the offset from the imaging plane beyond which elevation() is 0.
  double sliceReach_mm() const;

 private:
  /// Field profiles at several depths (nodes), from the axis outward, in steps that grow with the beam's width: step_mm
  /// by [node], value by [node][entry].
  struct Profiles {
    int entries = 0;
    std::vector<double> step_mm;  ///< distance between entries of a profile, [node]
    std::vector<float> value;     ///< relative amplitude of the field, [node][entry]
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
  std::vector<double> sliceIntegral_mm_, sliceSd_mm_;  // properties of the slice profile at each node
};

}  // namespace insonate
