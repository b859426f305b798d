const maps = [...document.querySelectorAll(".map")];
for (const map of maps) {
  const pieces = [...map.querySelectorAll(".piece")];
  const readout = map.querySelector(".readout");
  const tell = (piece) => { readout.textContent = piece.querySelector("title").textContent; };
  const hint = readout.textContent;
  pieces.forEach((piece, index) => {
    piece.setAttribute("tabindex", index ? "-1" : "0");
    piece.addEventListener("mouseenter", () => tell(piece));
    piece.addEventListener("focus", () => tell(piece));
    piece.addEventListener("keydown", (event) => {
      const to = { ArrowRight: index + 1, ArrowLeft: index - 1, Home: 0, End: pieces.length - 1 }[event.key];
      if (to === undefined || !pieces[to]) return;
      event.preventDefault();
      piece.setAttribute("tabindex", "-1");
      pieces[to].setAttribute("tabindex", "0");
      pieces[to].focus();
    });
  });
  map.addEventListener("mouseleave", () => { if (!map.contains(document.activeElement)) readout.textContent = hint; });
}
for (const states of document.querySelectorAll(".states")) {
  const show = () => {
    const chosen = states.querySelector("input:checked").value;
    maps.forEach((map) => { map.hidden = map.id !== chosen; });
  };
  states.addEventListener("change", show);
  states.hidden = false;
  show();
}
