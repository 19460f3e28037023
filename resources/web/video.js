// Jumps in the video of an attempt, and marks the present time on the timeline and in the list of events.
"use strict";
const video = document.querySelector("video");
const cursor = document.querySelector(".timeline .cursor");
const links = [...document.querySelectorAll("[data-time]")];
const rows = links.filter(link => link.closest("ol"));

for (const link of links)
  link.addEventListener("click", event => {
    event.preventDefault();
    video.currentTime = Number(link.dataset.time);
    video.scrollIntoView({block: "nearest"});
  });

function follow() {
  const x = 100 * Math.min(1, video.currentTime / Number(cursor.dataset.length)) + "%";
  cursor.setAttribute("x1", x);
  cursor.setAttribute("x2", x);
  const present = rows.filter(row => Number(row.dataset.time) <= video.currentTime + 0.05).pop();
  for (const row of rows)
    if (row === present) row.setAttribute("aria-current", "true");
    else row.removeAttribute("aria-current");
}
video.addEventListener("timeupdate", follow);
video.addEventListener("seeked", follow);
