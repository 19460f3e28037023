#pragma once

#include "../files/NumberNames.h"
#include "../files/OwnNumbers.h"
#include "PartComposer.h"

#include <insonate/cases/LabelFile.h>

namespace insonate {

/// Role of a structure, as its file states it. Only organs are read unless the author asks for more.
enum class StructureRole {
  kOrgan,
  kPlan,    ///< part of a radiotherapy plan, e.g. a target volume, which is no anatomy
  kOutline  ///< outline of the body, which lies below all other structures
};

/// Collects structures from one or more files of other programs, and makes labels for a case from them.
class LabelAssembly {
 public:
  LabelAssembly(const PatientCase& patient, const StructureChoices& choices)
      : patient_(patient), choices_(choices), composer_(patient.ct.geometry) {}

  /// Keeps the numbers of own labels that the names state.
  void keepNumbers(const NumberNames& names);
  /// Adds a structure, and returns its number for placing its voxels; the caller places no voxels of a structure that
  /// was left out. `source` begins the sentence on an unknown structure, e.g. "The mask".
  Result<std::uint16_t> add(std::int32_t number, const NumberName& described, const std::string& source,
                            StructureRole role = StructureRole::kOrgan);
  /// Adds a structure that the file names, but that has no voxels.
  Result<std::uint16_t> addEmpty(std::int32_t number, const NumberName& described);
  bool isRead(std::uint16_t number) const { return result_.structures[number - 1u].state != StructureState::kLeftOut; }
  /// Adds all structures of a file that was read already.
  Result<void> adopt(LabelReadResult&& read, const Progress& progress);

  PartComposer& composer() { return composer_; }
  void addNote(std::string note) { result_.notes.push_back(std::move(note)); }

  /// Returns the labels. Fails if all structures lie outside the CT.
  Result<LabelReadResult> finish();

 private:
  int priorityOf(const ReadStructure& structure) const;
  void fillLabels();
  void forgetUnused();
  void noteUnited();

  const PatientCase& patient_;
  const StructureChoices& choices_;
  PartComposer composer_;
  OwnNumbers numbers_;
  LabelReadResult result_;
};

}  // namespace insonate
