#include "workstations/WorkstationPages.h"

#include <insonate/curriculum/Workstations.h>

namespace insonate::web {
namespace {

Markup rowsOf(const Visit& visit, const std::vector<Workstation>& workstations) {
  std::vector<std::vector<Markup>> rows;
  for (const Workstation& one : workstations) {
    const Markup name = element("input", {{"type", "hidden"}, {"name", "name"}, {"value", one.name}});
    rows.push_back({text(one.name), one.revoked_us ? text("revoked, ") + timeOf(*one.revoked_us) : text("in use"),
                    one.seen_us ? timeOf(*one.seen_us) : text("no request yet"), timeOf(one.added_us),
                    text(one.addedBy),
                    one.revoked_us ? Markup() : postForm(visit, "/workstations/revoke", name, "Revoke")});
  }
  return table("Workstations of this site", {"Name", "Token", "Last request", "Added", "Added by", "Revoke"}, rows);
}

Response workstationsPage(const Visit& visit, const std::string& trouble, const std::string& name) {
  const auto workstations = Workstations(*visit.by).list();
  if (!workstations) return refusal(visit, 403, workstations.error().message);
  Markup content = note(
      "A workstation is a computer on which people train. It sends attempts to this server. The server accepts them if "
      "the workstation has a valid token, which you can revoke at any time.");
  content += workstations->empty() ? paragraph("There are no workstations yet.") : rowsOf(visit, *workstations);
  Markup form;
  if (!trouble.empty()) form += troubleLine(trouble);
  form += postForm(visit, "/workstations", inputField("Name", "name", "text", "off", name), "Add");
  content +=
      section("Add a workstation", note("Enter the name that the command hostname prints on the workstation. To "
                                        "replace a lost token, revoke the token and add the workstation again.") +
                                       form);
  return page(visit, "Workstations", content, trouble.empty() ? 200 : 422);
}

}  // namespace

Response showWorkstations(const Visit& visit, const Parts& /*parts*/) {
  return workstationsPage(visit, {}, {});
}

Response addWorkstation(const Visit& visit, const Parts& /*parts*/) {
  const std::string& name = valueOf(visit.request.form, "name");
  const auto token = Workstations(*visit.by).add(name);
  if (!token) return workstationsPage(visit, token.error().message, name);
  return page(visit, "Token of " + name,
              paragraph("Copy this token now: it cannot be shown again. On the workstation, choose \"Hospital server\" "
                        "in the menu at the top right; if Insonate is started there for the first time, choose \"A "
                        "site\". Then enter the address of this server and the token.") +
                  element("p", {}, element("code", {{"class", "token"}}, *token)) +
                  element("p", {}, link("/workstations", "All workstations")));
}

Response revokeWorkstation(const Visit& visit, const Parts& /*parts*/) {
  const auto revoked = Workstations(*visit.by).revoke(valueOf(visit.request.form, "name"));
  return revoked ? redirect("/workstations") : workstationsPage(visit, revoked.error().message, {});
}

}  // namespace insonate::web
