#include <insonate/simulator/AttemptOrigin.h>
#include <insonate/simulator/ServoRecord.h>

#include <cstdint>
#include <cstdio>
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
  std::uint64_t hash = 0xcbf29ce484222325U;
  const auto add = [&](std::uint64_t value) { hash = (hash ^ value) * 0x100000001b3U; };
  for (const int size : patient.labels.geometry.size) add(static_cast<std::uint64_t>(size));
  for (const auto label : patient.labels.voxels) add(label);
  for (const auto hu : patient.ct.voxels) add(static_cast<std::uint16_t>(hu));
  char text[20];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
  return text;
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
