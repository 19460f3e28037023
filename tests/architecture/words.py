"""The rules of plain words that a machine can check: comments, window texts, help and README. Each rule yields sentences:
where, what, and what to write instead."""

import re

COMMENT = re.compile(r"^\s*//[/!]?<?\s*(.*)")
OPENER = re.compile(r"(Of|To|What|Where|Who|Whoever|Whose|Whether|Which|So that|How)\b")
TRAILING_COMMENT = re.compile(r"[;,{)]\s*//[/!]?<?\s+(Of|To|What|Where|Who|Whoever|Whose|Whether|Which|So that|How)\b")

# Pattern in any case, what to write instead.
BANNED = [
    (r"pictures?", "image"),
    (r"callipers?", "caliper"),
    (r"(colour|colours|coloured|centre|centres|centred|grey|behaviour|neighbours?|metres?|millimetres?|centimetres?)",
     "US spelling: color, center, gray, behavior, neighbor, meter"),
    (r"(who sits here|whoever|somebody)", "user, trainee, instructor or person"),
    (r"(take|takes|taken) back", "undo"),
    (r"do(es)? again", "redo"),
    (r"sav(e|es|ed|ing) over", "overwrite"),
    (r"read theirs", "reload"),
    (r"lay(s|ing)? (it )?(away|down)", "deselect or put down"),
    (r"(hang|hangs) together", "connected"),
    (r"how far it is", "progress"),
    (r"needs you", "needs attention"),
    (r"images/s", "frames per second"),
    (r"double puncture", "posterior wall puncture"),
    (r"tells? it", "no data"),
    (r"(doubts?|troubles?)", "finding, error, warning or note"),
    (r"(nobody|someone|anybody)", "user, trainee, instructor or person"),
    (r"in plane(?! strain)", "in-plane"),
    (r"out of plane", "out-of-plane"),
    (r"(least depth|slice focus|opening of the (probe|array|transducer))", "aperture, near field, far field or elevation focus"),
    (r"(press(es|ed|ing)? (on )?(the )?(tissues?|veins?|arter(y|ies)|vessels?|skin|neck)|probe press(es|ed)?|presses the probe)",
     "compress"),
    (r"(dark|black) (vessels?|lumens?|veins?|arter(y|ies)|tissues?)", "anechoic or hypoechoic"),
    (r"grains? of (the )?(tissue|image)", "speckle"),
    (r"draws? on the syringe", "aspirate"),
    (r"(beating blood|blood (that )?beats)", "pulsatile"),
    (r"(ways? of the needle|needle's way)", "path, insertion or pass"),
    (r"los(e|es|ing) (it|them|(the|your|all) (changes|work))", "discard"),
    (r"(goes|going) on", "continue, progress"),
    (r"com(e|es|ing) behind", "lower priority"),
    (r"make hounsfield units", "conversion to HU"),
]
BANNED = [(re.compile(rf"\b{pattern}\b", re.I), instead) for pattern, instead in BANNED]

# Comments of public headers: openers that leave the reader without a subject, and terms that have one word only.
HEADER_OPENER = re.compile(r"(As|If|Another|Something|Must|Like|With|Without|For|Given|Made|Drawn|Written|Also|It|They)\b")
HEADER_TERMS = [
    (r"imaging planes?", "image plane"),
    (r"(patient|probe|device|stylus)'s frame", "patient space, probe frame, device frame or stylus frame"),
    (r"at right angles", "perpendicular"),
    (r"running numbers?", "number, consecutive from 1"),
]
HEADER_TERMS = BANNED + [(re.compile(rf"\b{pattern}\b", re.I), instead) for pattern, instead in HEADER_TERMS]
CODE = re.compile(r"`[^`]*`|\"[^\"]*\"|\b\w*(?:[a-z][A-Z]|_|::|\.h\b|\()\w*")

TR = re.compile(r'\btr\(((?:\s*"(?:[^"\\]|\\.)*")+)')
LITERAL = re.compile(r'"((?:[^"\\]|\\.)*)"')
BUTTON = re.compile(r'(?:new\s+QPushButton|new\s+QToolButton|addAction|addButton|new\s+QAction)\(\s*(?:\w+\s*,\s*)?tr\(\s*"((?:[^"\\]|\\.)*)"')
MOST_WORDS_OF_A_BUTTON = 5
LIMIT = re.compile(r"\s*(at )?(least|most)\s*", re.I)
CLAUSE = re.compile(r"\b(is|are|was|were|has|have|what|which|who|that|you|it)\b", re.I)


PAGES = ["README.md", "ARCHITECTURE.md", "CONTRIBUTING.md"]


def line_of(text, position):
    return text.count("\n", 0, position) + 1


def texts_of(source):
    """(position, text) of each tr() with its adjoining literals put together."""
    for match in TR.finditer(source):
        yield match.start(), "".join(LITERAL.findall(match.group(1)))


def files(root, folders, suffixes):
    for folder in folders:
        if (root / folder).is_dir():
            yield from sorted(f for f in (root / folder).rglob("*") if f.suffix in suffixes)


def check_comments(root):
    for file in files(root, ["modules", "ui", "app", "tests", "shaders"], {".h", ".cpp", ".glsl", ".comp"}):
        before = False
        for number, line in enumerate(file.read_text(encoding="utf-8", errors="replace").splitlines(), start=1):
            comment = COMMENT.match(line)
            opener = OPENER.match(comment.group(1)) if comment and not before else TRAILING_COMMENT.search(line)
            if opener:
                yield (f'{file.relative_to(root)}:{number}: a comment begins with "{opener.group(1)}"; begin with a verb or with a '
                       "noun that names the thing")
            before = comment is not None


def comments_of(source):
    """(line, text) of each comment of a header, with the lines that continue it."""
    lines = source.splitlines()
    number = 0
    while number < len(lines):
        if match := re.search(r"(?:^|\s)//[/!]?<?(.*)", lines[number]):
            first, text = number + 1, [match.group(1).strip()]
            while number + 1 < len(lines) and (more := COMMENT.match(lines[number + 1])):
                text.append(more.group(1))
                number += 1
            yield first, " ".join(text).strip()
        number += 1


def check_header_comments(root):
    for file in files(root, ["modules", "ui"], {".h"}):
        if "include" not in file.relative_to(root).parts:
            continue
        for number, text in comments_of(file.read_text(encoding="utf-8", errors="replace")):
            if opener := HEADER_OPENER.match(text):
                yield (f'{file.relative_to(root)}:{number}: the comment begins with "{opener.group(1)}"; begin with a verb or with a '
                       "noun that names the thing")
            for pattern, instead in HEADER_TERMS:
                if match := pattern.search(CODE.sub("", text)):
                    yield f'{file.relative_to(root)}:{number}: "{match.group(0)}" in a comment; say: {instead}'


def check_window_texts(root):
    for file in files(root, ["ui", "app"], {".h", ".cpp"}):
        source = file.read_text(encoding="utf-8", errors="replace")
        for position, text in texts_of(source):
            for pattern, instead in BANNED:
                if match := pattern.search(text):
                    yield f'{file.relative_to(root)}:{line_of(source, position)}: "{match.group(0)}" in a window text; say: {instead}'
            if LIMIT.fullmatch(text):
                yield f'{file.relative_to(root)}:{line_of(source, position)}: the label "{text}"; say: minimum or maximum'


def check_buttons(root):
    for file in files(root, ["ui", "app"], {".h", ".cpp"}):
        source = file.read_text(encoding="utf-8", errors="replace")
        for match in BUTTON.finditer(source):
            text = match.group(1).split("\\t")[0]
            if (text.endswith(".") and not text.endswith("...")) or len(text.split()) > MOST_WORDS_OF_A_BUTTON or CLAUSE.search(text):
                yield (f'{file.relative_to(root)}:{line_of(source, match.start())}: the button "{text}" is a sentence; use a verb or a '
                       "noun")


def check_pages(root):
    pages = list(files(root, ["resources/help"], {".md"})) + [root / name for name in PAGES] + sorted(root.glob("*/*/README.md"))
    for page in pages:
        if not page.is_file():
            continue
        fenced = False
        for number, line in enumerate(page.read_text(encoding="utf-8").splitlines(), start=1):
            fenced ^= line.startswith("```")
            prose = re.sub(r"`[^`]*`|\]\([^)]*\)", "", line)
            for pattern, instead in [] if fenced else BANNED:
                if match := pattern.search(prose):
                    yield f'{page.relative_to(root)}:{number}: "{match.group(0)}"; say: {instead}'


RULES = [check_comments, check_header_comments, check_window_texts, check_buttons, check_pages]
