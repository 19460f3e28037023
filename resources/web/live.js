"use strict";
// Shows new data of this page when they arrive: the server sends the event "changed", and the content is asked for
// again. Without this script the page stays as it is until it is reloaded.
{
  const main = document.getElementById("main");
  const shortestPause_ms = 5000;
  const longestDelay_ms = 2000;
  let source = null;
  let isDue = false;
  let isWaiting = false;
  let isOver = false;

  const announcement = document.createElement("p");
  announcement.className = "quiet updated";
  announcement.setAttribute("role", "status");
  main.before(announcement);

  // Typed text and an open list would be lost, and a video would begin again.
  const isInUse = () => {
    const fields = [...main.querySelectorAll("input, textarea")];
    return (
      main.querySelector("input:focus, textarea:focus, select:focus, video") !== null ||
      fields.some((field) => field.value !== field.defaultValue || field.checked !== field.defaultChecked)
    );
  };

  const replaceContent = (content) => {
    const focused = document.activeElement;
    const address = main.contains(focused) ? focused.getAttribute("href") : null;
    main.replaceChildren(...content.childNodes);
    if (address === null) return;
    const same = [...main.querySelectorAll("a")].find((link) => link.getAttribute("href") === address);
    if (same) same.focus({ preventScroll: true });
  };

  const refresh = async () => {
    if (isInUse() || document.visibilityState !== "visible") {
      announcement.textContent = "There are new data. Reload the page to see them.";
      return;
    }
    // Before the question: a change that arrives meanwhile is due again.
    isDue = false;
    // The header tells the server that no person asked, so that the session can end.
    const answer = await fetch(location.href, { headers: { "Insonate-Refresh": "1" } });
    if (answer.status >= 500) {
      isDue = true;
      return;
    }
    if (!answer.ok || answer.redirected) {
      isOver = true;
      close();
      announcement.textContent = "This page is not updated any more. Reload it to see new data.";
      return;
    }
    const page = new DOMParser().parseFromString(await answer.text(), "text/html");
    const content = page.getElementById("main");
    if (!content || isInUse()) {
      isDue = true;
      return;
    }
    replaceContent(content);
    // The new content does not change any more, for example that of an attempt that was verified.
    if (content.dataset.events === undefined) {
      isOver = true;
      close();
    } else {
      main.dataset.events = content.dataset.events;
    }
    const time = new Date().toLocaleTimeString([], { hour: "2-digit", minute: "2-digit", second: "2-digit" });
    announcement.textContent = `Updated at ${time}`;
  };

  const pause = (duration_ms) => new Promise((done) => setTimeout(done, duration_ms));

  // At most one update in five seconds, however fast attempts arrive. All pages of a class learn of a change at once;
  // they ask one after another.
  const refreshSoon = async () => {
    isDue = true;
    if (isWaiting) return;
    isWaiting = true;
    while (isDue && !isOver) {
      await pause(Math.random() * longestDelay_ms);
      try {
        await refresh();
      } catch {
        isDue = true;
      }
      await pause(shortestPause_ms);
    }
    isWaiting = false;
  };

  const close = () => {
    if (source) source.close();
    source = null;
  };
  const open = () => {
    if (source || isOver) return;
    source = new EventSource(main.dataset.events);
    source.addEventListener("changed", refreshSoon);
    // A browser gives up after an error of the server or of a proxy, for example while the server is restarted.
    source.addEventListener("error", () => {
      if (source && source.readyState === EventSource.CLOSED) {
        close();
        setTimeout(follow, 30000);
      }
    });
  };

  // A browser keeps few connections to a server: pages in the background release theirs.
  const follow = () => (document.visibilityState === "visible" ? open() : close());
  document.addEventListener("visibilitychange", follow);
  follow();
}
