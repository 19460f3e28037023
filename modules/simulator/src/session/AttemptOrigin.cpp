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

AttemptHeader headerOf(const Procedure& procedure, const PatientCase& patient, const Probe& probe,
                       std::string_view software) {
  AttemptHeader header;
  header.software = software;
  header.begun = now();
  header.procedure = procedure.name, header.procedureVersion = procedure.version;
  header.caseName = patient.manifest.title;
  header.picture = imageFieldOf(probe);
  return header;
}

}  // namespace insonate
