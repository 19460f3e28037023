"""Opens each page of insonate-server in a headless Chromium, in each role and at the widths of phone, laptop and desktop.

browser_test.py SERVER [FOLDER]: SERVER is the program; screenshots go to FOLDER. Exit status 77: no browser here.
"""

import base64
import html
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import urllib.error
import urllib.parse
import urllib.request

try:
    from selenium import webdriver
    from selenium.common.exceptions import TimeoutException, WebDriverException
    from selenium.webdriver.chrome.service import Service
    from selenium.webdriver.common.action_chains import ActionChains
    from selenium.webdriver.common.by import By
    from selenium.webdriver.common.keys import Keys
    from selenium.webdriver.common.print_page_options import PrintOptions
    from selenium.webdriver.support.ui import WebDriverWait
except ImportError:
    print("Skipped: python3-selenium is not installed")
    sys.exit(77)

DRIVER = pathlib.Path("/usr/bin/chromedriver")
WIDTHS = {"phone": 390, "laptop": 1366, "desktop": 1920}
ROLES = {"made-up-001": "trainee", "made-up-teacher": "instructor", "made-up-administrator": "administrator"}
PASSWORD = "made-up password"
# Pages that differ only by person or attempt are opened this often for each role and width.
MOST_OF_A_KIND = 1
MOST_PRINTED = 50
# Links that are followed without a browser, for each role.
MOST_FOLLOWED = 10_000

# What a screen reader and a person with weak sight need: names of controls, labels of fields, one main heading, contrast.
CHECKS = """
const found = [];
for (const field of document.querySelectorAll('input:not([type=hidden], [hidden]), select, textarea'))
  if (!field.labels || !field.labels.length || !field.labels[0].textContent.trim()) found.push('no label: ' + field.outerHTML);
for (const one of document.querySelectorAll('a[href], button, summary'))
  if (!one.textContent.trim()) found.push('no name: ' + one.outerHTML);
for (const image of document.querySelectorAll('svg[role=img], img'))
  if (!image.getAttribute('aria-label') && !image.getAttribute('alt')) found.push('no description: ' + image.outerHTML.slice(0, 80));
if (document.querySelectorAll('h1').length != 1) found.push('not one main heading');
if (!document.documentElement.lang) found.push('no language');
const ids = [...document.querySelectorAll('[id]')].map(one => one.id);
if (new Set(ids).size != ids.length) found.push('an id occurs twice');
if (document.documentElement.scrollWidth > document.documentElement.clientWidth) found.push('wider than the window');
const parts = color => color.match(/[\\d.]+/g).map(Number);
const luminance = color => parts(color).slice(0, 3).map(c => c / 255)
  .map(c => c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4)
  .reduce((sum, c, i) => sum + c * [0.2126, 0.7152, 0.0722][i], 0);
const ground = node => {
  for (; node; node = node.parentElement) {
    const color = getComputedStyle(node).backgroundColor;
    if (parts(color).length < 4 || parts(color)[3] > 0) return color;
  }
  return 'rgb(255, 255, 255)';
};
for (const one of document.querySelectorAll('p, a, li, th, td, dt, dd, h1, h2, h3, span, label, button, summary, caption, time')) {
  if (one.closest('.hidden, .skip') || ![...one.childNodes].some(node => node.nodeType == 3 && node.textContent.trim())) continue;
  const a = luminance(getComputedStyle(one).color), b = luminance(ground(one));
  const contrast = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
  if (contrast < 4.5) found.push('contrast ' + contrast.toFixed(1) + ': ' + one.outerHTML.slice(0, 120));
}
const contrastOf = (one, two) => {
  const [a, b] = [luminance(one), luminance(two)];
  return (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
};
// WCAG 1.4.11: borders of fields, marks of charts and of the timeline.
const visible = selector => [...document.querySelectorAll(selector)]
  .filter(one => one.checkVisibility({visibilityProperty: true}) && !one.closest('.hidden, .skip'));
for (const one of visible('button, input:not([type=hidden], [type=radio], [type=checkbox]), select, textarea')) {
  const contrast = contrastOf(getComputedStyle(one).borderTopColor, ground(one.parentElement));
  if (contrast < 3) found.push('contrast of the border ' + contrast.toFixed(1) + ': ' + one.outerHTML.slice(0, 80));
}
const marks = ['passed', 'failed', 'other', 'limit', 'curve', 'box', 'median', 'marked', 'milestone', 'error', 'comment', 'axis', 'cursor'];
for (const one of visible('svg ' + marks.map(name => '.' + name).join(', svg '))) {
  const style = getComputedStyle(one);
  const contrast = contrastOf(style.stroke == 'none' ? style.fill : style.stroke, ground(one.ownerSVGElement));
  if (contrast < 3) found.push('contrast of a mark ' + contrast.toFixed(1) + ': ' + one.outerHTML.slice(0, 80));
}
// WCAG 2.5.8: targets of 24 x 24 pixels, or that far from others; links within a sentence are excepted.
const targets = visible('a[href], button, input:not([type=hidden]), select, textarea, summary, video')
  .filter(one => one.tagName != 'A' || one.parentElement.textContent.trim() == one.textContent.trim() || !one.closest('p, li, dd'))
  .map(one => ({one, box: (one.type == 'radio' || one.type == 'checkbox' ? one.closest('label') : one).getBoundingClientRect()}))
  .filter(({box}) => box.width > 0 && box.right > 0);
const isSmall = box => box.width < 23.9 || box.height < 23.9;
const around = box => {
  const [x, y] = [(box.left + box.right) / 2, (box.top + box.bottom) / 2];
  return {left: x - 11.9, right: x + 11.9, top: y - 11.9, bottom: y + 11.9};
};
const meet = (a, b) => a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
for (const {one, box} of targets.filter(({box}) => isSmall(box))) {
  const near = targets.find(other => other.one != one && meet(around(box), isSmall(other.box) ? around(other.box) : other.box));
  if (near) found.push('target of ' + box.width.toFixed(0) + ' x ' + box.height.toFixed(0) + ' pixels beside another: '
    + one.outerHTML.slice(0, 80) + ' and ' + near.one.outerHTML.slice(0, 80));
}
return found;
"""


# The element with the focus: its place in the page, whether its focus is drawn, and whether it is hidden (WCAG 2.4.7, 2.4.11).
FOCUSED = """
const one = document.activeElement;
if (!one || one == document.body) return null;
const style = getComputedStyle(one), box = one.getBoundingClientRect();
const seen = [[0.5, 0.5], [0.1, 0.5], [0.9, 0.5], [0.5, 0.1], [0.5, 0.9]].some(([x, y]) => {
  const top = document.elementFromPoint(box.left + x * box.width, box.top + y * box.height);
  return top && (one.contains(top) || top.contains(one));
});
const all = [...document.querySelectorAll('*')];
return [all.indexOf(one), style.outlineStyle != 'none' && parseFloat(style.outlineWidth) >= 2, seen, one.outerHTML.slice(0, 100)];
"""
# What the Tab key must reach; of radio buttons it reaches one of a group.
FOCUSABLE = """
const all = [...document.querySelectorAll('*')];
return all.map((one, place) => [one, place]).filter(([one]) => one.checkVisibility({visibilityProperty: true})
  && one.matches('a[href], button, select, textarea, summary, input:not([type=hidden], [type=radio])'))
  .map(([one, place]) => [place, one.outerHTML.slice(0, 100)]);
"""


def keyboard(driver):
    """Walks through the page with the Tab key. Yields what is wrong."""
    expected = dict(driver.execute_script(FOCUSABLE))
    # The walk begins at the top, not where the last click was.
    driver.execute_script("window.scrollTo(0, 0); document.body.tabIndex = -1; document.body.focus(); "
                          "document.body.removeAttribute('tabindex')")
    reached = set()
    for _ in range(len(expected) + 60):
        ActionChains(driver).send_keys(Keys.TAB).perform()
        if not (focused := driver.execute_script(FOCUSED)):
            break
        place, is_drawn, is_seen, words = focused
        if place in reached and len(reached) >= len(expected):
            break
        reached.add(place)
        if not is_drawn:
            yield f"the focus is not drawn: {words}"
        if not is_seen:
            yield f"the focus is hidden: {words}"
    for place, words in expected.items():
        if place not in reached:
            yield f"the Tab key does not reach {words}"


def resize(driver, width):
    """Sets the width of the page, which a window of a desktop browser does not go below 500 pixels."""
    driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {"width": width, "height": 1000, "deviceScaleFactor": 1, "mobile": False})


def narrow(driver):
    """Shows the page in a window of 320 pixels, as a page that is enlarged to 400 % (WCAG 1.4.10). Yields what is wrong."""
    before = driver.execute_script("return window.innerWidth")
    resize(driver, 320)
    try:
        if (width := driver.execute_script("return document.documentElement.scrollWidth")) > 320:
            wide = driver.execute_script(
                "return [...document.querySelectorAll('main *')].filter(one => one.getBoundingClientRect().right > 321"
                " && !one.closest('.scroll')).map(one => one.outerHTML.slice(0, 80)).slice(0, 3)")
            yield f"{width} pixels wide in a window of 320: {wide}"
        yield from (f"at 320 pixels: {sentence}" for sentence in driver.execute_script(CHECKS))
    finally:
        resize(driver, before)


def browser(width, scheme):
    options = webdriver.ChromeOptions()
    for argument in ("--headless=new", "--no-sandbox", "--disable-gpu", "--hide-scrollbars", "--disable-dev-shm-usage",
                     f"--window-size={width},1000", f"--blink-settings=preferredColorScheme={0 if scheme == 'dark' else 1}"):
        options.add_argument(argument)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    driver = webdriver.Chrome(service=Service(str(DRIVER)), options=options)
    resize(driver, width)
    driver.implicitly_wait(10)  # on a busy computer a page may not be there yet
    return driver


def kind(path):
    """The address without what differs between pages of one kind: ids and names of levels."""
    return re.sub(r"/levels/\w+", "/levels/NAME", re.sub(r"[0-9a-f]{8}-[0-9a-f-]{27}", "ID", path.split("?")[0]))


def sign_in(driver, base, name, password=PASSWORD):
    driver.delete_all_cookies()
    driver.get(base + "sign-in")
    driver.find_element(By.NAME, "name").send_keys(name)
    driver.find_element(By.NAME, "password").send_keys(password)
    driver.find_element(By.CSS_SELECTOR, "main button").click()
    # The next address would interrupt the form on its way.
    WebDriverWait(driver, 30).until(lambda _: not driver.current_url.endswith("/sign-in"))


def is_gone(element):
    """Tells whether the page of an element was replaced; while it is, the browser has several errors for it."""
    try:
        element.is_enabled()
        return False
    except WebDriverException:
        return True


def press(driver, words, row=""):
    """Clicks a button or a link of the page, or of a row of a table, and waits until another page has taken its place."""
    main = driver.find_element(By.TAG_NAME, "main")
    within = f".//tr[td[text()='{row}']]" if row else "."
    main.find_element(By.XPATH, f"{within}//*[(self::button or self::a) and normalize-space()='{words}']").click()
    WebDriverWait(driver, 60).until(lambda _: is_gone(main))


def walk(driver, base, label, folder):
    """Opens what the links of the home page lead to, and what those lead to. Yields what is wrong."""
    waiting, opened, seen = [base], {}, set()
    while waiting:
        address = waiting.pop(0)
        path = "/" + address.removeprefix(base)
        if path in seen or opened.get(kind(path), 0) >= MOST_OF_A_KIND:
            continue
        seen.add(path)
        opened[kind(path)] = opened.get(kind(path), 0) + 1
        driver.get(address)
        title = driver.title
        for error in driver.get_log("browser"):
            yield f"{label} {path}: {error['message']}"
        if title.startswith(("Not ", "Request refused")):
            yield f"{label} {path}: a link leads to '{title}'"
        for sentence in driver.execute_script(CHECKS):
            yield f"{label} {path}: {sentence}"
        if folder:
            name = label + kind(path).replace("/", "_") + str(opened[kind(path)])
            driver.save_screenshot(str(folder / (name.replace(" ", "-") + ".png")))
        if label.startswith("laptop"):
            yield from (f"{label} {path}: {sentence}" for sentence in keyboard(driver))
            yield from (f"{label} {path}: {sentence}" for sentence in narrow(driver))
        # In one step, since a live page may be replaced between two.
        links = driver.execute_script("return [...document.querySelectorAll('main a[href], nav a[href]')].map(a => a.href)")
        waiting += [link for link in links if link.startswith(base)]
    if not any("/attempts/ID" in one for one in opened):
        yield f"{label}: no attempt was reached, only {sorted(opened)}"


def every_link(base, name):
    """Follows each link of a user without a browser, which takes milliseconds a page. Yields links that lead nowhere."""
    opener = urllib.request.build_opener(urllib.request.HTTPCookieProcessor())
    form = urllib.parse.urlencode({"name": name, "password": PASSWORD}).encode()
    opener.open(urllib.request.Request(base + "sign-in", form, {"Sec-Fetch-Site": "same-origin"})).read()
    waiting, seen = ["/"], {"/"}
    while waiting and len(seen) < MOST_FOLLOWED:
        path = waiting.pop()
        try:
            with opener.open(base.rstrip("/") + path) as answer:
                text = answer.read().decode(errors="replace") if answer.headers.get_content_type() == "text/html" else ""
        except urllib.error.HTTPError as error:
            yield f"{name}: a link leads to {path}, which has status {error.code}"
            continue
        links = {html.unescape(link) for link in re.findall(r'href="(/[^"#]*)', text)} - seen
        seen |= links
        waiting += sorted(links)
    print(f"{name}: {len(seen)} links followed", flush=True)
    if waiting:
        yield f"{name}: more than {MOST_FOLLOWED} links"


def comment(driver, base, folder):
    """An instructor comments on an attempt, and its trainee reads the comment. Yields what is wrong."""
    sign_in(driver, base, "made-up-001")
    attempt = driver.find_element(By.CSS_SELECTOR, "main a[href*='/attempts/']").get_attribute("href")
    driver.delete_all_cookies()
    # The session has ended: the page that was asked for comes after signing in.
    driver.get(attempt)
    driver.find_element(By.NAME, "name").send_keys("made-up-teacher")
    driver.find_element(By.NAME, "password").send_keys(PASSWORD)
    driver.find_element(By.CSS_SELECTOR, "main button").click()
    try:
        WebDriverWait(driver, 30).until(lambda _: driver.current_url == attempt)
    except TimeoutException:
        yield f"signing in leads to {driver.current_url}, not to {attempt}"
    for time, expected in {"soon": "is not a time", "0:01": "Hold the probe still."}.items():
        field = driver.find_element(By.NAME, "at")
        field.clear()
        field.send_keys(time)
        text = driver.find_element(By.NAME, "text")
        text.clear()
        text.send_keys("Hold the probe still.")
        press(driver, "Add comment")
        if expected not in driver.find_element(By.TAG_NAME, "main").text:
            yield f"a comment at '{time}' does not say '{expected}'"
        for sentence in driver.execute_script(CHECKS):
            yield f"comment at {time}: {sentence}"
        if folder:
            driver.save_screenshot(str(folder / f"comment-{time.replace(':', '-')}.png"))
    sign_in(driver, base, "made-up-001")
    driver.get(attempt)
    if "Hold the probe still." not in driver.find_element(By.TAG_NAME, "main").text:
        yield "the trainee does not see the comment"


def debrief(driver, base, folder, width):
    """An instructor fills in a debrief of an attempt, which its trainee reads in the briefing. Yields what is wrong."""
    sign_in(driver, base, "made-up-001")
    attempt = driver.find_element(By.CSS_SELECTOR, "main a[href*='/attempts/']").get_attribute("href")
    advice = f"Rest the hand on the neck, said at {width}."
    author = {"phone": "made-up-001", "laptop": "made-up-teacher", "desktop": "made-up-administrator"}[width]
    sign_in(driver, base, author)
    driver.get(attempt)
    press(driver, "Fill in: Debrief")
    for name, answer in {"went_well": "The view.", "happened": "Two passes.", "next": advice}.items():
        driver.find_element(By.NAME, f"answer-{name}").send_keys(answer)
    if folder:
        driver.save_screenshot(str(folder / f"debrief-{width}.png"))
    press(driver, "Hand in")
    driver.find_element(By.XPATH, f"//details[.//*[contains(., '{advice}')]]/summary").click()
    if advice not in driver.find_element(By.TAG_NAME, "main").text:
        yield f"the attempt does not show the debrief at {width}"
    yield from (f"debrief at {width}: {sentence}" for sentence in driver.execute_script(CHECKS))
    sign_in(driver, base, "made-up-001")
    briefings = {link.get_attribute("href") for link in driver.find_elements(By.CSS_SELECTOR, "main a[href*='/levels/']")}
    for briefing in briefings:
        driver.get(briefing)
        if advice in driver.find_element(By.TAG_NAME, "main").text:
            break
    else:
        yield f"no briefing of {sorted(briefings)} repeats the debrief at {width}"
    if folder:
        driver.save_screenshot(str(folder / f"briefing-{width}.png"))


def opening(driver, base, folder, width):
    """An instructor opens a test for a time window, is warned when it is opened again, and closes it. Yields what is wrong."""
    sign_in(driver, base, "made-up-teacher")
    driver.get(base + "classes")
    driver.get(driver.find_element(By.CSS_SELECTOR, "main tbody a").get_attribute("href") + "/tests")
    end = driver.find_element(By.NAME, "end").get_attribute("value")
    if not re.fullmatch(r"\d{4}-\d\d-\d\dT\d\d:\d\d", end):
        yield f"the end of a test is proposed as '{end}'"
    for step, button in (("opened", "Open"), ("warned", "Open")):
        press(driver, button)
        if folder:
            driver.save_screenshot(str(folder / f"opening-{step}-{width}.png"))
        yield from (f"{step} at {width}: {sentence}" for sentence in driver.execute_script(CHECKS))
    shown = driver.find_element(By.TAG_NAME, "main").text
    if "is open already" not in shown or not driver.find_elements(By.XPATH, "//main//button[text()='Open again']"):
        yield f"a test that is open already was opened again without a warning at {width}"
    press(driver, "Close")
    if "closed by" not in driver.find_element(By.TAG_NAME, "main").text:
        yield f"the test was not closed at {width}"


def portfolio(driver, base, folder, width):
    """A trainee prints the portfolio as PDF: without the navigation, and with the answers of raters."""
    sign_in(driver, base, "made-up-001")
    driver.get(base + "me/portfolio")
    pdf = base64.b64decode(driver.print_page(PrintOptions()))
    if folder:
        (folder / f"{width}-portfolio.pdf").write_bytes(pdf)
    if not pdf.startswith(b"%PDF-") or len(pdf) < 10_000:
        yield f"{width}: the portfolio was printed as {len(pdf)} bytes"
    driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": "print"})
    for shown in driver.find_elements(By.CSS_SELECTOR, "nav, form, .screen"):
        if shown.is_displayed():
            yield f"{width}: the printed portfolio shows {shown.get_attribute('outerHTML')[:80]}"
    driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": ""})


def live(base, folder):
    """The page of a class shows by itself what was done in another browser."""
    page, other = browser(WIDTHS["laptop"], "dark"), browser(WIDTHS["laptop"], "dark")
    try:
        sign_in(page, base, "made-up-teacher")
        page.get(base.rstrip("/") + "/classes")
        page.find_element(By.CSS_SELECTOR, "main a[href^='/classes/']").click()
        sign_in(other, base, "made-up-teacher")
        troubles = list(comment(other, base, None))
        try:
            WebDriverWait(page, 30).until(lambda d: "Updated at" in d.find_element(By.CSS_SELECTOR, "[role=status]").text)
        except TimeoutException:
            troubles.append("The page of a class was not updated after a comment")
        if folder:
            page.save_screenshot(str(folder / "live.png"))
        return troubles + [f"live: {entry['message']}" for entry in page.get_log("browser")]
    finally:
        page.quit()
        other.quit()


def administer(driver, base, folder, width):
    """An administrator adds a person and imports a list, and those people sign in. Yields what is wrong."""

    def expect(step, *words):
        shown = driver.find_element(By.TAG_NAME, "main").text
        yield from (f"{step} at {width}: the page does not say '{one}'" for one in words if one not in shown)
        yield from (f"{step} at {width}: {sentence}" for sentence in driver.execute_script(CHECKS))
        if folder:
            driver.save_screenshot(str(folder / f"administer-{width}-{step}.png"))

    def signs_in(name):
        password = driver.find_element(By.CSS_SELECTOR, "main code").text
        sign_in(driver, base, name, password)
        if "password" not in driver.current_url:
            yield f"{name} need not choose a password, and is at {driver.current_url}"

    sign_in(driver, base, "made-up-administrator")
    driver.get(base + "people")
    driver.find_element(By.NAME, "name").send_keys(f"added.{width}")
    driver.find_element(By.NAME, "full-name").send_keys("Dr Added")
    press(driver, "Add")
    yield from expect("added", "Password of Dr Added", "cannot be shown again")
    yield from signs_in(f"added.{width}")

    sign_in(driver, base, "made-up-administrator")
    driver.get(base + "classes")
    driver.get(driver.find_element(By.CSS_SELECTOR, "main tbody a").get_attribute("href"))
    press(driver, "Members and settings")
    members = driver.current_url
    press(driver, "Import a list of trainees")
    with tempfile.NamedTemporaryFile(suffix=".csv") as file:
        file.write(f"Vorname;Nachname;Anmeldename\nZoë;Zäh;zoe.{width}\nBad;Name;two words\n".encode("latin-1"))
        file.flush()
        driver.find_element(By.NAME, "list").send_keys(file.name)
        press(driver, "Check the list")
    yield from expect("checked", "New accounts: 1.", "Zoë Zäh", "left out")
    press(driver, "Import")
    yield from expect("imported", "First passwords", "Zoë Zäh")
    yield from signs_in(f"zoe.{width}")

    sign_in(driver, base, "made-up-administrator")
    driver.get(members)
    press(driver, "Remove", row=f"zoe.{width}")
    yield from expect("removed", "Members of the class")
    if "Zoë Zäh" in driver.find_element(By.TAG_NAME, "main").text:
        yield f"the person who was removed at {width} is still in the class"


def recorded_class(command_line, folder):
    """Makes a class with one attempt that has a recording; returns the database and the recording."""
    database = folder / "class.db"
    subprocess.run([command_line, "curriculum", "demo", database, "--trainees", "1", "--attempts", "2", "--recorded", "1"],
                   env=os.environ | {"INSONATE_NEW_PASSWORD": PASSWORD}, check=True, capture_output=True)
    return database, next((folder / "attempts").glob("*.attempt"))


# The mean brightness of the present frame of the video, which a page without rights on it could not read.
BRIGHTNESS = """
const video = document.querySelector('video'), canvas = document.createElement('canvas');
canvas.width = canvas.height = 180;
const context = canvas.getContext('2d');
context.drawImage(video, 0, 0, 180, 180);
const pixels = context.getImageData(0, 0, 180, 130).data;
return pixels.reduce((sum, value, i) => sum + (i % 4 ? 0 : value), 0) / (pixels.length / 4);
"""


def watch(driver, base, attempt, label, folder):
    """Plays the video of an attempt. Yields what is wrong."""
    driver.get(attempt)
    wait = WebDriverWait(driver, 30)
    ready = "const v = document.querySelector('video'); return v && v.readyState >= 2 && !v.seeking && v.currentTime"
    try:
        wait.until(lambda _: driver.execute_script(ready) is not False)
        length = driver.execute_script("return document.querySelector('video').duration")
        if not 5 < length < 60:
            yield f"{label}: the video has a duration of {length} s"
        link = driver.find_elements(By.CSS_SELECTOR, ".moments a")[-1]
        time = float(link.get_attribute("data-time"))
        link.click()
        wait.until(lambda _: abs(float(driver.execute_script(ready) or -1) - time) < 0.2)
        if driver.current_url != attempt:
            yield f"{label}: an event leads away to {driver.current_url}"
        if "true" not in [one.get_attribute("aria-current") for one in driver.find_elements(By.CSS_SELECTOR, ".moments a")]:
            yield f"{label}: no event is marked as the present one"
        driver.execute_script("document.querySelector('video').currentTime = 6")
        wait.until(lambda _: abs(float(driver.execute_script(ready) or -1) - 6) < 0.2)
        cursor = driver.execute_script("return document.querySelector('.timeline .cursor').getAttribute('x1')")
        if abs(float(cursor.rstrip("%")) - 600 / length) > 2:
            yield f"{label}: at 6 s of {length} s, the timeline shows {cursor}"
        if not 10 < driver.execute_script(BRIGHTNESS) < 200:
            yield f"{label}: the frame is no ultrasound image"
    except TimeoutException:
        yield f"{label}: the video does not play or jump: " + str(driver.execute_script(
            "const v = document.querySelector('video'); return v ? [v.readyState, v.currentTime, v.error && v.error.message] : 'none'"))
    for sentence in [*driver.execute_script(CHECKS), *keyboard(driver), *narrow(driver)]:
        yield f"{label} video: {sentence}"
    for error in driver.get_log("browser"):
        yield f"{label} video: {error['message']}"
    if folder:
        driver.execute_script("document.querySelector('#video').scrollIntoView()")
        driver.save_screenshot(str(folder / f"video-{label}.png"))
    # Without the script, the same link opens the video alone at that time.
    driver.get(base + "me")
    driver.get(attempt.split("?")[0] + f"/video.webm#t={time}")
    try:
        wait.until(lambda _: abs(float(driver.execute_script(ready) or -1) - time) < 1)
    except TimeoutException:
        yield f"{label}: the link without script does not open the video at {time} s"


def video(server_program, folder):
    """A trainee asks for the video of an attempt, and watches it. Yields what is wrong."""
    command_line = pathlib.Path(server_program).with_name("insonate-cli")
    with tempfile.TemporaryDirectory() as own:
        database, recording = recorded_class(command_line, pathlib.Path(own))
        server = subprocess.Popen([server_program, database, "--listen", "127.0.0.1:0"], stdout=subprocess.PIPE,
                                  stderr=subprocess.DEVNULL, text=True)
        try:
            base = next(match.group(0) for line in server.stdout if (match := re.search(r"http://\S+", line)))
            attempt = None
            for width_name, width in WIDTHS.items():
                driver = browser(width, "dark" if width_name == "laptop" else "light")
                try:
                    sign_in(driver, base, "made-up-001")
                    if not attempt:
                        links = driver.find_elements(By.CSS_SELECTOR, "main a[href*='/attempts/']")
                        attempt = links[0].get_attribute("href")
                        identity = re.search(r"/attempts/([0-9a-f-]+)", attempt).group(1)
                        kept = pathlib.Path(f"{database}.recordings")
                        kept.mkdir(exist_ok=True)
                        shutil.copy(recording, kept / f"{identity}.attempt")
                        driver.get(attempt)
                        driver.find_element(By.XPATH, "//button[text()='Make video']").click()
                        if "the video" not in driver.find_element(By.TAG_NAME, "main").text.lower():
                            yield "the page does not say that the video is being made"
                        if folder:
                            driver.save_screenshot(str(folder / "video-progress.png"))
                        WebDriverWait(driver, 600).until(lambda _: driver.find_elements(By.TAG_NAME, "video"))
                    yield from watch(driver, base, attempt, width_name, folder)
                finally:
                    driver.quit()
        finally:
            server.terminate()
            if server.wait(timeout=20) != 0:
                yield f"The server with videos ended with status {server.returncode}"


def main():
    if not DRIVER.exists():
        print("Skipped: chromium-driver is not installed")
        return 77
    folder = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else None
    if folder:
        folder.mkdir(parents=True, exist_ok=True)
    server = subprocess.Popen([sys.argv[1], "--demo", "--listen", "127.0.0.1:0"], stdout=subprocess.PIPE,
                              stderr=subprocess.DEVNULL, text=True)
    try:
        base = next(match.group(0) for line in server.stdout if (match := re.search(r"http://\S+", line)))
        troubles = []
        for width_name, width in WIDTHS.items():
            driver = browser(width, "dark" if width_name == "laptop" else "light")
            try:
                for name, role in ROLES.items():
                    sign_in(driver, base, name)
                    troubles += walk(driver, base, f"{width_name} {role}", folder)
                    print(f"{width_name} {role}: {len(troubles)} findings so far", flush=True)
                troubles += comment(driver, base, folder)
                troubles += debrief(driver, base, folder, width_name)
                troubles += opening(driver, base, folder, width_name)
                troubles += portfolio(driver, base, folder, width_name)
                troubles += administer(driver, base, folder, width_name)
                driver.find_element(By.XPATH, "//button[text()='Sign out']").click()
                try:
                    WebDriverWait(driver, 30).until(lambda one: "Sign in" in one.title)
                except TimeoutException:
                    troubles.append(f"{width_name}: signing out leads to '{driver.title}'")
            finally:
                driver.quit()
        troubles += live(base, folder)
        for name in ROLES:
            troubles += every_link(base, name)
    finally:
        server.terminate()
        if server.wait(timeout=20) != 0:
            troubles.append(f"The server ended with status {server.returncode}")
    troubles += video(sys.argv[1], folder)
    print("\n".join(troubles[:MOST_PRINTED]) if troubles else "All pages of all roles are as they should be.")
    return 1 if troubles else 0


sys.exit(main())
