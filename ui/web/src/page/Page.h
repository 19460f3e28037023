#pragma once

#include "http/Messages.h"
#include "page/Markup.h"

#include <insonate/core/Result.h>
#include <insonate/curriculum/CurriculumStore.h>
#include <insonate/curriculum/SignedIn.h>
#include <insonate/web/WebServer.h>

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace insonate {
class PublishedCases;
}

namespace insonate::web {

class ClassContents;
class DownloadSlots;
class LiveUpdates;
class Metrics;
class OpenIdProvider;
class RecentImports;

/// One request, with the user who makes it.
struct Visit {
  const Request& request;
  const CurriculumStore& store;
  const WebOptions& options;
  const Metrics& metrics;
  LiveUpdates& live;
  RecentImports& imports;
  DownloadSlots& downloads;
  const PublishedCases& cases;
  ClassContents& classes;
  OpenIdProvider* openId = nullptr;  ///< null: users sign in with their password only
  std::optional<SignedIn> by{};      ///< user; empty: no user is signed in; never empty in pages that require sign-in
  std::string secret{};              ///< secret of the browser's session (BrowserSessions); empty if there is none
};

/// Values of the variable parts of a path, in order: {"5"} for /classes/5.
using Parts = std::vector<std::string>;

/// Tells whether a page made a request without its user: to follow changes, to show them, or the progress of a video.
bool isByItself(const Request& request);

/// Returns a whole page: head, navigation for the user's role, title as heading, and content.
Response page(const Visit& visit, std::string_view title, const Markup& content, int status = 200);
/// Returns a page whose content the browser asks for again when an event of the stream at `events` says that it has
/// changed. `since`: LiveUpdates::numberOfLastChange() before the content was read.
Response livePage(const Visit& visit, std::string_view title, const Markup& content, const std::string& events,
                  std::int64_t since);
/// Returns the stream of events for a page that shows these people (Person::id).
Response follow(const Visit& visit, std::set<std::string> people);
/// Returns a page with one sentence that says why the requested page cannot be shown.
Response refusal(const Visit& visit, int status, std::string_view sentence);
/// Returns an answer that sends the browser to another address of this server by GET.
Response redirect(const std::string& address);

/// Returns a file that the browser saves under this name.
Response download(const std::string& fileName, const std::string& type, std::string content);

/// Returns a form that sends POST to `address`, with the code of the user's session.
Markup postForm(const Visit& visit, const std::string& address, const Markup& content, std::string_view button);
/// Does what postForm() does, for a form with a field of type "file".
Markup fileForm(const Visit& visit, const std::string& address, const Markup& content, std::string_view button);
/// Returns a labeled field. `type`: "text" or "password"; `completion`: value of the attribute autocomplete;
/// `value`: text that the field shows at first.
Markup inputField(std::string_view label, const std::string& name, const std::string& type,
                  const std::string& completion, const std::string& value = {});
/// Returns a labeled field that may stay empty.
Markup optionalField(std::string_view label, const std::string& name, const std::string& type,
                     const std::string& value = {});
/// Returns a field that the page does not show.
Markup hiddenField(const std::string& name, const std::string& value);
/// Returns a labeled field for a text of several lines; `value`: text that the field shows at first.
Markup textField(std::string_view label, const std::string& name, const std::string& value);
/// Values and texts of a list of choices.
using Choices = std::vector<std::pair<std::string, std::string>>;
/// Returns a labeled list of choices, of which `chosen` is selected.
Markup choiceField(std::string_view label, const std::string& name, const Choices& choices, std::string_view chosen);
/// Returns the code that forms of a session contain. The code proves that a form comes from a page of this session, and
/// does not reveal the session's secret.
std::string formCode(const std::string& secret);

/// Returns a section with a heading.
Markup section(std::string_view heading, const Markup& content);
Markup paragraph(std::string_view sentence);
/// Returns a less prominent paragraph, which explains the words or figures beside the paragraph.
Markup note(std::string_view sentence);
/// Returns the reason why a form was refused. Screen readers announce the reason.
Markup troubleLine(std::string_view sentence);
/// Returns a time in the server's time zone, "20 Nov 2026, 14:05 CET", with the exact time for programs.
Markup timeOf(std::int64_t time_us);
/// Returns the full name of a person, or the name for signing in if there is none.
std::string displayName(const Person& person);

}  // namespace insonate::web
