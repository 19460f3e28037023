#pragma once

#include <insonate/cases/PatientCase.h>

#include <filesystem>
#include <string_view>

namespace insonate {

/// Title of an imported CT until the author changes it. Titles are never taken from patient data.
inline constexpr std::string_view kImportedTitle = "Imported CT";

/// Sets the title of an untitled case to the name of its folder, e.g. "neck" for `/cases/neck.case`. Lists, training
/// levels and recordings identify cases by title.
void setTitleFromFolder(CaseManifest& manifest, const std::filesystem::path& folder);

}  // namespace insonate
