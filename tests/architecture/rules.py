"""The rules of ARCHITECTURE.md, read from the source tree. Each rule yields sentences: where, what, and the way out."""

import re
from pathlib import Path

import words

FLOORS = {
    "core": 0,
    "image": 1, "gpu": 1, "tissue": 1,
    "cases": 2,
    "segmentation": 3, "surface": 3, "deformation": 3, "ultrasound": 3, "haptics": 3, "procedure": 3, "curriculum": 3,
    "wire": 3, "camera": 3, "flow": 3.5,
    "simulator": 4, "teaching": 4, "site": 4,
    "video": 4.4, "preparation": 4.4, "igtlink": 4.4, "bench": 4.5,
    # The rooms of ui stand on views and on the shell, whose headers are insonate/ui/.
    "views": 5, "ui": 5.1, "prepare": 5.2, "train": 5.2, "review": 5.2, "web": 5.2,
    "app": 6,
}
# Made by the build from resources/: below every floor, and private.
GENERATED = "embedded"

TOP_LEVEL = {
    "CMakeLists.txt", "CMakePresets.json", "README.md", "ARCHITECTURE.md", "CONTRIBUTING.md", "CHANGELOG.md", "LICENSE",
    "app", "modules", "ui", "resources", "shaders", "tests", "packaging",
    ".ci", ".clang-format", ".clang-tidy", ".gitignore", ".git", "build",
}

SOURCES = {".h", ".hpp", ".cpp"}
MAX_LINES = 800
MAX_FUNCTION_LINES = 60
# Functions that may be longer, by file and name, each with the reason.
LONG_FUNCTIONS = {
    ("modules/cases/src/phantom/Variants.cpp", "variantModels"): "a table",
    ("modules/ultrasound/src/cpu/Cells-inl.h", "computeCellRow"): "one loop, whose parts share their registers",
    ("ui/prepare/src/tools/ToolTable.cpp", "growing"): "a table",
    ("ui/prepare/src/tools/ToolTable.cpp", "shaping"): "a table",
}

# Workspaces that are lists of features: folders of their src that each feature may include, and further pairs (who, whom).
FEATURES = {
    "train": ({"feature", "layout", "model"}, {("levels", "attempt"), ("line", "attempt"), ("measure", "patient3d")}),
    "prepare": ({"feature", "labels", "layout", "model"}, {("measure", "tools")}),
}

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')
OWN = re.compile(r"insonate/(\w+)/")
# Third-party headers, as include paths begin.
ITK_AND_GDCM = re.compile(r"(itk|gdcm)\w*\.h")
OPENCV = re.compile(r"opencv2?/")
SQL = re.compile(r"(QtSql/|QSql\w*|sqlite3\.h|libpq-fe\.h)")
HID = re.compile(r"(hidapi/|hidapi\.h)")
OPENGL = re.compile(r"(GL|EGL|KHR|epoxy)/")
JSON = re.compile(r"nlohmann/(?!json_fwd\.hpp)")
VTK = re.compile(r"vtk\w+\.h")
VTK_RENDERING = re.compile(
    r"vtk(Render\w*|\w*Renderer|\w*Mapper\w*|\w*Actor\w*|\w*Widget\w*|Interactor\w*|OpenGL\w*|\w*Window(?!ed)\w*|QVTK\w*)\.h|QVTK\w*")
QT = re.compile(r"(Qt\w+/|Q[A-Z]\w+$)")
QT_CORE_OR_SQL = re.compile(r"(QtCore/|QtSql/|QSql\w+$|Q(String|Variant|DateTime|Uuid|Object|File|Dir|CoreApplication|TextCodec)\w*$)")
PUBLIC_TYPES = re.compile(r"\b(itk|gdcm|cv)::\w|\bvtk[A-Z]\w+|\bnlohmann::(?!json\b|ordered_json\b)\w|\bQSql\w+|\bhid_device\b")
SQL_TEXT = re.compile(r'"\s*(SELECT\s.+\sFROM\s|INSERT\s+INTO\s|UPDATE\s+\w+\s+SET\s|DELETE\s+FROM\s|CREATE\s+TABLE\s)', re.I)
UNFINISHED = re.compile(r"\b(TODO|FIXME|XXX|HACK)\b")


def place(root, file):
    """(module, is public header) of a source file; module is None outside the floors."""
    parts = file.relative_to(root).parts
    if parts[0] == "modules" and len(parts) > 2:
        return parts[1], parts[2] == "include"
    if parts[0] == "ui" and len(parts) > 2:
        return {"shell": "ui"}.get(parts[1], parts[1]), False
    return (parts[0], False) if parts[0] in ("ui", "app") else (None, False)


def sources(root, *folders):
    for folder in folders:
        if (root / folder).is_dir():
            yield from sorted(f for f in (root / folder).rglob("*") if f.suffix in SOURCES)


def lines(file):
    return list(enumerate(file.read_text(encoding="utf-8", errors="replace").splitlines(), start=1))


def includes(file):
    for number, line in lines(file):
        if match := INCLUDE.match(line):
            yield number, match.group(2)


def check_floors(root):
    for file in sources(root, "modules", "ui", "app"):
        module, _ = place(root, file)
        if module not in FLOORS:
            yield f"{file.relative_to(root)}: module {module} has no floor; give it one in ARCHITECTURE.md and rules.py"
            continue
        for number, header in includes(file):
            match = OWN.match(header)
            if not match or match.group(1) in (module, GENERATED):
                continue
            other = match.group(1)
            where = f"{file.relative_to(root)}:{number}"
            if other not in FLOORS:
                yield f"{where}: includes {header}, of a module without a floor"
            elif FLOORS[other] > FLOORS[module]:
                yield f"{where}: {module} (floor {FLOORS[module]}) includes {header} (floor {FLOORS[other]}) above it"
            elif FLOORS[other] == FLOORS[module]:
                yield f"{where}: {module} includes {header} of its own floor; meet in the simulator instead"


def check_private_headers(root):
    """A module's private headers are found by name only inside that module; nobody reaches across by path."""
    for file in sources(root, "modules", "ui", "app", "tests"):
        for number, header in includes(file):
            if "/src/" in header or header.startswith("modules/") or header.startswith("../../"):
                yield f"{file.relative_to(root)}:{number}: includes {header}; use the module's public headers"


def check_public_headers(root):
    banned = {"ITK or GDCM": ITK_AND_GDCM, "OpenCV": OPENCV, "SQL": SQL, "hidapi": HID, "OpenGL": OPENGL, "VTK": VTK, "Qt": QT,
              "JSON (json_fwd.hpp is enough)": JSON, "generated by the build": re.compile(f"insonate/{GENERATED}/")}
    for file in sources(root, "modules"):
        if not place(root, file)[1]:
            continue
        for number, header in includes(file):
            for name, pattern in banned.items():
                if pattern.match(header):
                    yield f"{file.relative_to(root)}:{number}: a public header includes {header}: {name}; hide it in src"
        for number, line in lines(file):
            if PUBLIC_TYPES.search(line.split("//")[0]):
                yield f"{file.relative_to(root)}:{number}: a public header names a library's type; hide it in src"


def check_toolkits(root):
    for file in sources(root, "modules"):
        module, _ = place(root, file)
        for number, header in includes(file):
            where = f"{file.relative_to(root)}:{number}"
            if VTK_RENDERING.match(header):
                yield f"{where}: includes {header}; VTK rendering belongs in ui/views"
            elif VTK.match(header) and module != "surface":
                yield f"{where}: includes {header}; VTK filters belong in surface"
            if QT.match(header) and not (module == "curriculum" and QT_CORE_OR_SQL.match(header)):
                yield f"{where}: includes {header}; modules do without Qt, but for Qt Core and Qt Sql in curriculum"
            if HID.match(header) and module != "haptics":
                yield f"{where}: includes {header}; hidapi belongs in haptics"
            if OPENGL.match(header) and module != "gpu":
                yield f"{where}: includes {header}; OpenGL belongs in gpu"
    for file in sources(root, "ui/views"):
        for number, header in includes(file):
            if QT.match(header) or header.startswith("QVTK"):
                yield f"{file.relative_to(root)}:{number}: includes {header}; views know VTK only, Qt belongs in the rooms above"


def check_sql(root):
    for file in sources(root, "modules", "ui", "app"):
        if place(root, file)[0] == "curriculum":
            continue
        for number, header in includes(file):
            if SQL.match(header):
                yield f"{file.relative_to(root)}:{number}: includes {header}; SQL belongs in curriculum"
        for number, line in lines(file):
            if SQL_TEXT.search(line):
                yield f"{file.relative_to(root)}:{number}: contains an SQL statement; SQL belongs in curriculum"


def check_top_level(root):
    for entry in sorted(root.iterdir()):
        if entry.name not in TOP_LEVEL:
            yield f"{entry.name}: not a room of this house; see the tree in ARCHITECTURE.md"


def check_modules_complete(root):
    for module in sorted(p for p in (root / "modules").iterdir() if p.is_dir()):
        if not (module / "README.md").is_file():
            yield f"modules/{module.name}: has no README.md"
        has_code = any((module / "src").rglob("*.cpp"))
        if has_code and not any((root / "tests" / "unit" / module.name).glob("*.cpp")):
            yield f"modules/{module.name}: has no tests under tests/unit/{module.name}"


def check_length(root):
    for file in sources(root, "modules", "ui", "app", "tests"):
        count = len(lines(file))
        if count > MAX_LINES:
            yield f"{file.relative_to(root)}: {count} lines; split it by purpose (at most {MAX_LINES})"


# A function outside of classes as clang-format lays it out: it opens and closes in the first column.
FUNCTION = re.compile(r"(?!namespace|class|struct|enum|union|extern|constexpr|const |static const)[A-Za-z_~].*[^=]\s\{$")
FUNCTION_NAME = re.compile(r"([~\w]+)\(|TEST\w*\((\w+, *\w+)")


def check_functions(root):
    for file in sources(root, "modules", "ui", "app", "tests"):
        name, start, heading = str(file.relative_to(root)), None, ""
        for number, line in lines(file):
            if FUNCTION.match(line):
                start, heading = number, line
            elif line.startswith("}") and start is not None:
                length, function = number - start - 1, FUNCTION_NAME.search(heading)
                called = function.group(1) if function else heading
                if length > MAX_FUNCTION_LINES and (name, called) not in LONG_FUNCTIONS:
                    yield f"{name}:{start}: {called} has {length} lines; split it (at most {MAX_FUNCTION_LINES})"
                start = None


def check_basenames(root):
    """Two files of one name in a module are one idea in two places, or need names that tell them apart."""
    for parent in ("modules", "ui", "app"):
        for module in sorted(p for p in (root / parent).iterdir() if p.is_dir()) if (root / parent).is_dir() else []:
            seen = {}
            for file in sources(root, f"{parent}/{module.name}"):
                other = seen.setdefault(file.name, file)
                if other != file:
                    yield f"{file.relative_to(root)}: has the name of {other.relative_to(root)}; name one of them anew"


def check_features(root):
    """A feature of a workspace knows the model and the layout, and no other feature: it can be removed with its folder."""
    for workspace, (shared, exceptions) in FEATURES.items():
        source = root / "ui" / workspace / "src"
        for file in sources(root, f"ui/{workspace}/src"):
            if file.parent == source:
                continue
            folder = file.relative_to(source).parts[0]
            for number, header in includes(file):
                first = header.removeprefix("../").split("/")[0]
                other = first if header.startswith("../") or (source / first).is_dir() else folder
                if other not in shared | {folder} and (folder, other) not in exceptions:
                    yield f"{file.relative_to(root)}:{number}: {folder} includes {header} of another feature; meet in the model"


def check_finished(root):
    for file in sources(root, "modules", "ui", "app", "tests"):
        for number, line in lines(file):
            if UNFINISHED.search(line):
                yield f"{file.relative_to(root)}:{number}: unfinished: {line.strip()}"


def check_pragma_once(root):
    for file in sources(root, "modules", "ui", "app", "tests"):
        # "-inl.h" is Highway's name for what is compiled once for each instruction set.
        guarded = file.suffix != ".cpp" and not file.name.endswith("-inl.h")
        if guarded and "#pragma once" not in file.read_text(encoding="utf-8", errors="replace"):
            yield f"{file.relative_to(root)}: a header without #pragma once"


def check_architecture_page(root):
    """Names in ARCHITECTURE.md must exist: types in backticks and diagrams, headers as module/Header.h, all modules."""
    page = root / "ARCHITECTURE.md"
    if not page.is_file():
        return
    text = page.read_text(encoding="utf-8")
    code = "\n".join(f.read_text(encoding="utf-8", errors="replace") for f in sources(root, "modules", "ui") if f.suffix == ".h")
    types = set(re.findall(r"\b(?:class|struct|enum class|using)\s+(\w+)", code))
    diagrams = "\n".join(re.findall(r"```mermaid\n(.*?)```", text, re.S))
    prose = re.sub(r"```.*?```", "", text, flags=re.S)
    named = set(re.findall(r"`([A-Z][A-Za-z]*[a-z][A-Za-z]*)`", prose)) | set(re.findall(r"\b[A-Z][A-Za-z]+\b", diagrams)) - {"TB", "LR"}
    for name in sorted(named - types):
        yield f"ARCHITECTURE.md: names {name}, which no header has; correct the name"
    for module, header in re.findall(r"`(\w+)/(\w+\.h)`", prose):
        if not list(root.glob(f"*/*/include/insonate/{module}/{header}")):
            yield f"ARCHITECTURE.md: names {module}/{header}, which is no public header; correct the name"
    for module in sorted(set(FLOORS) - {"ui"} | {"shell"}) if diagrams else []:
        if not re.search(rf"\b{module}\b", diagrams):
            yield f"ARCHITECTURE.md: module {module} is missing in the picture of the floors; draw it"


RULES = [check_architecture_page, check_floors, check_private_headers, check_public_headers, check_toolkits, check_sql, check_top_level,
         check_modules_complete, check_length, check_functions, check_basenames, check_features, check_finished, check_pragma_once]


def violations(root):
    root = Path(root)
    return [sentence for rule in RULES + words.RULES for sentence in rule(root)]
