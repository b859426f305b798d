"use strict";
for (const box of document.querySelectorAll(".filter")) {
  const table = document.getElementById(box.dataset.table);
  const rows = [...table.tBodies].flatMap((body) => [...body.rows]);
  const texts = rows.map((row) => row.textContent.toLowerCase());
  const search = box.querySelector("input[type=search]");
  const toggles = [...box.querySelectorAll("input[type=checkbox]")];
  const shown = box.querySelector("output");
  const update = () => {
    const words = search.value.toLowerCase().split(/\s+/).filter(Boolean);
    const tags = toggles.filter((toggle) => toggle.checked).map((toggle) => toggle.value);
    let count = 0;
    rows.forEach((row, index) => {
      const own = (row.dataset.tags || "").split(" ");
      row.hidden = !(words.every((word) => texts[index].includes(word)) && (!tags.length || tags.some((tag) => own.includes(tag))));
      count += !row.hidden;
    });
    shown.textContent = count === rows.length ? `${count} rows` : `${count} of ${rows.length} rows`;
  };
  search.addEventListener("input", update);
  search.addEventListener("keydown", (event) => {
    if (event.key === "Escape") { search.value = ""; update(); }
  });
  toggles.forEach((toggle) => toggle.addEventListener("change", update));
  box.hidden = false;
  update();
}
document.addEventListener("keydown", (event) => {
  const first = document.querySelector(".filter input[type=search]");
  const isTyping = event.target.matches?.("input[type=search], textarea, select");
  if (event.key !== "/" || event.ctrlKey || event.metaKey || event.altKey || isTyping || !first) return;
  event.preventDefault();
  first.focus();
});
