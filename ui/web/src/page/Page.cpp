#include "page/Page.h"

#include "live/LiveUpdates.h"

#include <QDateTime>
#include <QLocale>
#include <QMessageAuthenticationCode>
#include <charconv>

namespace insonate::web {
namespace {

Markup navigation(const Visit& visit) {
  if (!visit.by) return {};
  Markup items = element("li", {}, link("/me", "My training"));
  if (visit.by->person().role != Role::Trainee)
    for (const auto& [address, words] : {std::pair{"/classes", "Classes"}, {"/curricula", "Curricula"}})
      items += element("li", {}, link(address, words));
  if (visit.by->person().role == Role::Administrator)
    for (const auto& [address, words] :
         {std::pair{"/people", "People"}, {"/workstations", "Workstations"}, {"/audit", "Audit log"}})
      items += element("li", {}, link(address, words));
  items += element("li", {{"class", "user"}}, displayName(visit.by->person()));
  items += element("li", {}, link("/password", "Change password"));
  items += element("li", {}, postForm(visit, "/sign-out", {}, "Sign out"));
  return element("nav", {{"aria-label", "Pages"}}, element("ul", {}, items));
}

Markup formContent(const Visit& visit, const Markup& content, std::string_view button) {
  Markup inside;
  if (!visit.secret.empty()) inside += hiddenField("code", formCode(visit.secret));
  return inside + content + element("button", {{"type", "submit"}}, button);
}

Response wholePage(const Visit& visit, std::string_view title, const Markup& content, int status,
                   const std::string& events) {
  const std::string inTitle = std::string(title) + " - Insonate";
  const Markup head = element("meta", {{"charset", "utf-8"}}, "") +
                      element("meta", {{"name", "viewport"}, {"content", "width=device-width, initial-scale=1"}}, "") +
                      element("meta", {{"name", "color-scheme"}, {"content", "dark light"}}, "") +
                      element("title", {}, inTitle) + element("link", {{"rel", "stylesheet"}, {"href", "/style.css"}}) +
                      element("link", {{"rel", "icon"}, {"href", "/icon.svg"}}) +
                      (events.empty() ? Markup() : element("script", {{"src", "/live.js"}, {"defer", ""}}, ""));
  const Markup skip = element("a", {{"class", "skip"}, {"href", "#main"}}, "Skip to the content");
  const Markup top =
      element("header", {}, element("a", {{"class", "brand"}, {"href", "/"}}, "Insonate") + navigation(visit));
  Attributes attributes{{"id", "main"}};
  if (!events.empty()) attributes.emplace_back("data-events", events);
  const Markup main = element("main", attributes, element("h1", {}, title) + content);
  Response response{.status = status};
  response.body =
      "<!DOCTYPE html>\n" +
      element("html", {{"lang", "en"}}, element("head", {}, head) + element("body", {}, skip + top + main)).html() +
      "\n";
  return response;
}

}  // namespace

bool isByItself(const Request& request) {
  const std::string_view path = request.path;
  return path.ends_with("/events") || (request.method == "GET" && path.ends_with("/video")) ||
         !valueOf(request.headers, "insonate-refresh").empty();
}

Response page(const Visit& visit, std::string_view title, const Markup& content, int status) {
  return wholePage(visit, title, content, status, {});
}

Response livePage(const Visit& visit, std::string_view title, const Markup& content, const std::string& events,
                  std::int64_t since) {
  return wholePage(visit, title, content, 200, events + "?since=" + std::to_string(since));
}

Response follow(const Visit& visit, std::set<std::string> people) {
  const std::string& last = valueOf(visit.request.headers, "last-event-id");
  const std::string& asked = last.empty() ? valueOf(visit.request.query, "since") : last;
  std::int64_t since = -1;
  std::from_chars(asked.data(), asked.data() + asked.size(), since);
  auto stream = visit.live.open(visit.by->person().id, std::move(people), since);
  if (!stream) return refusal(visit, 503, "Too many pages are open. Reload this page to see new data.");
  // Proxies such as nginx would hold events back until a block is full.
  return {.type = "text/event-stream", .headers = {{"X-Accel-Buffering", "no"}}, .events = std::move(stream)};
}

Response refusal(const Visit& visit, int status, std::string_view sentence) {
  const std::string_view title = status == 404   ? "Not found"
                                 : status == 403 ? "Not permitted"
                                 : status < 500  ? "Request refused"
                                                 : "Not available";
  return page(visit, title, paragraph(sentence), status);
}

Response redirect(const std::string& address) {
  return {.status = 303, .headers = {{"Location", address}}};
}

Response download(const std::string& fileName, const std::string& type, std::string content) {
  return {.type = type,
          .body = std::move(content),
          .headers = {{"Content-Disposition", "attachment; filename=\"" + fileName + "\""}}};
}

Markup postForm(const Visit& visit, const std::string& address, const Markup& content, std::string_view button) {
  return element("form", {{"method", "post"}, {"action", address}}, formContent(visit, content, button));
}

Markup fileForm(const Visit& visit, const std::string& address, const Markup& content, std::string_view button) {
  return element("form", {{"method", "post"}, {"action", address}, {"enctype", "multipart/form-data"}},
                 formContent(visit, content, button));
}

Markup inputField(std::string_view label, const std::string& name, const std::string& type,
                  const std::string& completion, const std::string& value) {
  return element("label", {},
                 text(label) + element("input", {{"type", type},
                                                 {"name", name},
                                                 {"value", value},
                                                 {"required", ""},
                                                 {"maxlength", "200"},
                                                 {"autocomplete", completion}}));
}

Markup optionalField(std::string_view label, const std::string& name, const std::string& type,
                     const std::string& value) {
  return element(
      "label", {},
      text(label) +
          element("input",
                  {{"type", type}, {"name", name}, {"value", value}, {"maxlength", "200"}, {"autocomplete", "off"}}));
}

Markup hiddenField(const std::string& name, const std::string& value) {
  return element("input", {{"type", "hidden"}, {"name", name}, {"value", value}});
}

Markup textField(std::string_view label, const std::string& name, const std::string& value) {
  return element(
      "label", {},
      text(label) +
          element("textarea", {{"name", name}, {"required", ""}, {"maxlength", "4000"}, {"rows", "4"}}, value));
}

Markup choiceField(std::string_view label, const std::string& name, const Choices& choices, std::string_view chosen) {
  Markup options;
  for (const auto& [value, words] : choices) {
    Attributes attributes{{"value", value}};
    if (value == chosen) attributes.emplace_back("selected", "");
    options += element("option", attributes, words);
  }
  return element("label", {}, text(label) + element("select", {{"name", name}}, options));
}

std::string formCode(const std::string& secret) {
  return QMessageAuthenticationCode::hash("form", QByteArray::fromStdString(secret), QCryptographicHash::Sha256)
      .toHex()
      .toStdString();
}

Markup section(std::string_view heading, const Markup& content) {
  return element("section", {}, element("h2", {}, heading) + content);
}

Markup paragraph(std::string_view sentence) {
  return element("p", {}, sentence);
}

Markup note(std::string_view sentence) {
  return element("p", {{"class", "quiet"}}, sentence);
}

Markup troubleLine(std::string_view sentence) {
  return element("p", {{"class", "trouble"}, {"role", "alert"}}, sentence);
}

Markup timeOf(std::int64_t time_us) {
  const QDateTime time = QDateTime::fromMSecsSinceEpoch(time_us / 1000);
  return element("time", {{"datetime", time.toUTC().toString(Qt::ISODate).toStdString()}},
                 (QLocale(QLocale::English).toString(time, QStringLiteral("d MMM yyyy, HH:mm")) + QLatin1Char(' ') +
                  time.timeZoneAbbreviation())
                     .toStdString());
}

std::string displayName(const Person& person) {
  return person.fullName.empty() ? person.name : person.fullName;
}

}  // namespace insonate::web
