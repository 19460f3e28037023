#pragma once

#include <insonate/cases/PatientCase.h>

#include <filesystem>
#include <string_view>

namespace insonate {

/// Title of an imported CT until the author names it: patient data must never become a title by themselves.
inline constexpr std::string_view kImportedTitle = "Imported CT";

/// Gives an unnamed case the name of its folder ("neck" of `/cases/neck.case`): lists, levels and recordings identify
/// cases by their titles.
void nameAfterFolder(CaseManifest& manifest, const std::filesystem::path& folder);

}  // namespace insonate
