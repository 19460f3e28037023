#pragma once

#include <insonate/cases/PatientCase.h>

#include <filesystem>
#include <string_view>

namespace insonate {

/// Title of an imported CT until the author names it: patient data must never become a title by themselves.
inline constexpr std::string_view kImportedTitle = "Imported CT";

/// A case that nobody has named takes the name its author chose for its folder ("neck" of `/cases/neck.case`): lists,
/// levels and recordings tell cases apart by their titles.
void nameAfterFolder(CaseManifest& manifest, const std::filesystem::path& folder);

}  // namespace insonate
