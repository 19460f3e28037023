#pragma once

#include "page/Page.h"

namespace insonate::web {

/// Shows the classes that the user may see; for administrators, a form to add one.
Response showClasses(const Visit& visit, const Parts& parts);
/// Adds the class that the form names.
Response addClass(const Visit& visit, const Parts& parts);
/// Sends the attempts of a class as CSV, its grades for Moodle, or its xAPI statements; the class's id is the only
/// part. The query of grades has "by" (email or name), that of statements "home" (address of the site).
Response exportClassAttempts(const Visit& visit, const Parts& parts);
Response exportClassGrades(const Visit& visit, const Parts& parts);
Response exportClassStatements(const Visit& visit, const Parts& parts);
/// Shows who needs attention, the members and the heat map of a class, whose id is the only part.
Response showClass(const Visit& visit, const Parts& parts);

}  // namespace insonate::web
