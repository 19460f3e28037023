#pragma once

#include "page/Page.h"

namespace insonate::web {

/// Shows the classes that the user may see; for administrators, a form to add one.
Response showClasses(const Visit& visit, const Parts& parts);
/// Adds the class that the form names.
Response addClass(const Visit& visit, const Parts& parts);
/// These three functions send a file about a class: its attempts as CSV, its grades for Moodle, or its xAPI statements.
/// `parts`: the id of the class. The query of grades has "by" (email or name), the query of statements "home" (address
/// of the site).
Response exportClassAttempts(const Visit& visit, const Parts& parts);
Response exportClassGrades(const Visit& visit, const Parts& parts);
Response exportClassStatements(const Visit& visit, const Parts& parts);
/// Shows the people of a class who need attention, the members, and the heat map. `parts`: the id of the class.
Response showClass(const Visit& visit, const Parts& parts);
/// Sends an event whenever data of a class have changed (livePage()).
Response followClass(const Visit& visit, const Parts& parts);

}  // namespace insonate::web
