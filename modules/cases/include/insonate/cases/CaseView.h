#pragma once

#include <insonate/cases/PatientCase.h>

#include <memory>
#include <utility>

namespace insonate {

/// A read-only view of a case: its manifest, its CT, and either its labels or another label map, e.g. one that is being
/// edited. The view holds references; the manifest, the CT and the labels must outlive the view.
struct CaseView {
  const CaseManifest& manifest;
  const CtVolume& ct;
  const LabelMap& labels;

  CaseView(const PatientCase& patient)
      : CaseView(patient, patient.labels) {}  // implicit, so that a case can be passed as a view
  CaseView(const PatientCase& patient, const LabelMap& instead) : CaseView(patient.manifest, patient.ct, instead) {}
  CaseView(const CaseManifest& about, const CtVolume& volume, const LabelMap& map)
      : manifest(about), ct(volume), labels(map) {}
};

/// Shared ownership of a case's CT, and of its labels or another label map. If only the labels are replaced, the CT is
/// not copied. The volumes must not change while they are shared.
struct CaseVolumes {
  std::shared_ptr<const CtVolume> ct;
  std::shared_ptr<const LabelMap> labels;
  std::shared_ptr<const std::vector<NamedVessel>> vessels;  ///< named vessels of the manifest

  /// Shares a patient's volumes and vessels; all pointers are null if `patient` is null.
  CaseVolumes(const std::shared_ptr<const PatientCase>& patient)
      : CaseVolumes(patient, patient ? std::shared_ptr<const LabelMap>(patient, &patient->labels) : nullptr) {}
  CaseVolumes(const std::shared_ptr<const PatientCase>& patient, std::shared_ptr<const LabelMap> instead)
      : ct(patient ? std::shared_ptr<const CtVolume>(patient, &patient->ct) : nullptr),
        labels(std::move(instead)),
        vessels(patient ? std::shared_ptr<const std::vector<NamedVessel>>(patient, &patient->manifest.vessels)
                        : nullptr) {}
};

}  // namespace insonate
