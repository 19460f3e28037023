#pragma once

#include <insonate/cases/PatientCase.h>

#include <filesystem>
#include <string_view>

namespace insonate {

/// Title of an imported CT until the author names it. Titles are never taken from patient data.
inline constexpr std::string_view kImportedTitle = "Imported CT";

/// Gives an untitled case the name of its folder ("neck" for `/cases/neck.case`), because lists, training levels and
/// recordings identify cases by their title.
void nameAfterFolder(CaseManifest& manifest, const std::filesystem::path& folder);

}  // namespace insonate
