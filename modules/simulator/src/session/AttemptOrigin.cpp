#include <insonate/core/Fingerprint.h>
#include <insonate/simulator/AttemptOrigin.h>
#include <insonate/simulator/ServoRecord.h>

#include <cstdint>
#include <ctime>

namespace insonate {
namespace {

std::string now() {
  const std::time_t seconds = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&seconds, &utc);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text;
}

}  // namespace

std::string caseHashOf(const PatientCase& patient) {
  Fingerprint fingerprint;
  for (const int size : patient.labels.geometry.size) fingerprint.add(static_cast<std::uint64_t>(size));
  for (const auto label : patient.labels.voxels) fingerprint.add(std::uint64_t{label});
  for (const auto hu : patient.ct.voxels) fingerprint.add(std::uint64_t{static_cast<std::uint16_t>(hu)});
  return fingerprint.text();
}

AttemptHeader headerOf(const Procedure& procedure, const PatientCase& patient, const Probe& probe,
                       std::string_view software) {
  AttemptHeader header;
  header.software = software;
  header.begun = now();
  header.procedure = procedure.name, header.procedureVersion = procedure.version;
  header.caseName = patient.manifest.title;
  header.picture = pictureFieldOf(probe);
  return header;
}

}  // namespace insonate
