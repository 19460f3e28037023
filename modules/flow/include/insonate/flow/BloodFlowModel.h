#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/deformation/Physiology.h>
#include <insonate/flow/VesselAreas.h>
#include <insonate/image/BloodFlow.h>

#include <memory>
#include <optional>
#include <span>

namespace insonate {

/// Volume flow through a vessel.
struct VesselFlow {
  double now_mm3ps = 0;   ///< volume flow at the time, positive in the physiological direction
  double mean_mm3ps = 0;  ///< volume flow averaged over heartbeats and breaths
};

/// Blood flow in the named vessels of a case. Arteries have a pulsatile volume flow and the velocity profile of
/// Womersley; the flow of veins follows heartbeat and breathing, with a parabolic profile. The volume flow is the same
/// at all points of a vessel, so that velocity is higher where the vessel is narrower. resources/flow has the numbers
/// with their sources; README.md has the equations. One object must not be used concurrently.
class BloodFlowModel {
 public:
  /// Copies the vessels. Vessels without a name in resources/flow get a flow that follows from their radius; labels
  /// other than artery and vein have no flow. `labels` is the label map of the case, in which filled lumens are found,
  /// e.g. by a thrombus: the flow of the vessels beyond them falls to that of collaterals. Null: all lumens are open.
  explicit BloodFlowModel(std::span<const NamedVessel> vessels, const LabelMap* labels = nullptr);
  ~BloodFlowModel();
  BloodFlowModel(BloodFlowModel&&) noexcept;
  BloodFlowModel& operator=(BloodFlowModel&&) noexcept;

  /// Computes the velocities at a time in s; without a time, the velocities of the mean flow. The physiology must be
  /// valid. `areas` are the present areas of the vessels (see computeVesselAreas()); empty: those in the CT. A vessel
  /// that is compressed to less than kClosedArea at any point has no flow. Before, its flow falls with the resistance
  /// of the narrowed part. `flow` has one tube for each vessel, in the order of the vessels. Allocates nothing if
  /// `flow` has been used before and the heart rate has not changed.
  void at(const Physiology& physiology, std::optional<double> time_s, const VesselAreas& areas, BloodFlow& flow) {
    at(physiology, time_s, areas, {}, flow);
  }
  /// Computes the velocities and adds the flow of blood that a compression expels from veins toward the heart
  /// (augmentation), or that refills them. `rates_perS` are the rates of change of `areas`, in the same order; empty:
  /// the areas do not change.
  void at(const Physiology& physiology, std::optional<double> time_s, const VesselAreas& areas,
          const VesselAreas& rates_perS, BloodFlow& flow);

  /// Returns the volume flow through a vessel, by its index, as computed by the last call of at().
  VesselFlow volumeFlow(std::size_t vessel) const;

  std::span<const NamedVessel> vessels() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace insonate
