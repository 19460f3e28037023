#include "site/SiteApi.h"

#include "monitoring/FailureLog.h"

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

Response listCases(const Visit& visit, const Parts& /*parts*/) {
  if (const auto workstation = senderOf(visit.request, visit.store); !workstation) return workstation.error();
  auto list = visit.cases.listText();
  if (list) return {.type = "application/json", .body = std::move(*list)};
  logFailure(visit.options.log, "cases failed", list.error().message);
  return plain(422, "The server cannot read its cases. Tell the administrator of the server.");
}

Response sendCasePart(const Visit& visit, const Parts& /*parts*/) {
  if (const auto workstation = senderOf(visit.request, visit.store); !workstation) return workstation.error();
  constexpr std::string_view kFiles = "case-files/";
  const auto part = visit.cases.part(visit.request.path.substr(kSiteApi.size() + kFiles.size()));
  if (!part) return plain(422, part.error().message);
  Response response{.type = "application/octet-stream"};
  response.file = part->file, response.fileBegin = part->begin, response.fileSize = part->size;
  return response;
}

}  // namespace insonate::web
