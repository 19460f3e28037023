#include "site/SiteApi.h"

#include <insonate/curriculum/SiteService.h>
#include <insonate/site/PublishedCases.h>

#include <cstdint>

namespace insonate::web {
namespace {

Response plain(int status, std::string text) {
  return {.status = status, .type = "text/plain; charset=utf-8", .body = std::move(text)};
}

}  // namespace

tl::expected<std::string, Response> senderOf(const Request& request, const CurriculumStore& store) {
  constexpr std::string_view kBearer = "Bearer ";
  const std::string& authorization = valueOf(request.headers, "authorization");
  if (!authorization.starts_with(kBearer))
    return tl::unexpected(plain(401, "The request has no token of a workstation.\n"));
  const auto workstation = SiteService(store).workstationOf(authorization.substr(kBearer.size()));
  if (!workstation) return tl::unexpected(plain(503, workstation.error().message));
  if (!*workstation) return tl::unexpected(plain(401, "The token is not valid.\n"));
  return **workstation;
}

Response answerWorkstation(const Visit& visit, const Parts& /*parts*/) {
  const Request& request = visit.request;
  const auto workstation = senderOf(request, visit.store);
  if (!workstation) return workstation.error();
  const auto recordingsPerDay_bytes = static_cast<std::int64_t>(visit.options.recordingsPerDay_GB * 1e9);
  auto answer = SiteService(visit.store, recordingsPerDay_bytes)
                    .answer(*workstation, request.path.substr(kSiteApi.size()), request.body);
  if (!answer) return plain(422, answer.error().message);
  return {.type = "application/json", .body = std::move(*answer)};
}

Response answerForCases(const Visit& visit, const Parts& /*parts*/) {
  const auto workstation = senderOf(visit.request, visit.store);
  if (!workstation) return workstation.error();
  auto answer = answerCaseRequest(visit.options.cases, visit.request.path.substr(kSiteApi.size()));
  if (!answer) return plain(422, answer.error().message);
  return {.type = "application/octet-stream", .body = std::move(*answer)};
}

}  // namespace insonate::web
