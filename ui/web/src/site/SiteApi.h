#pragma once

#include "page/Page.h"

#include <string_view>

namespace insonate::web {

/// Beginning of the addresses at which workstations exchange data with the server. Requests to these addresses contain
/// a token in the header Authorization and no cookie, so that no page of another site can use these addresses.
inline constexpr std::string_view kSiteApi = "/api/site/";

/// Returns the name of the workstation that sent a request, or the refusal: status 401 without a valid token, 503 if
/// the database cannot be read.
tl::expected<std::string, Response> senderOf(const Request& request, const CurriculumStore& store);
/// Answers a request of a workstation (SiteService): status 200 with the answer, 401 without a valid token, 422 with a
/// sentence that says why the request is refused.
Response answerWorkstation(const Visit& visit, const Parts& parts);
/// Sends the list of published cases to a workstation (PublishedCases::listText()), with the same statuses.
Response listCases(const Visit& visit, const Parts& parts);
/// Sends a part of a file of a published case to a workstation (PublishedCases::part()), with the same statuses.
Response sendCasePart(const Visit& visit, const Parts& parts);

}  // namespace insonate::web
