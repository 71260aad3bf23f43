// What keyboards and screen readers need and the theme lacks.
function accessible() {
  document.querySelector(".md-search")?.setAttribute("aria-label", "Search");
  for (const box of document.querySelectorAll("pre > code, .md-typeset__table, .md-typeset__scrollwrap, .output, figure, .md-sidebar__scrollwrap")) {
    if (box.scrollWidth > box.clientWidth || box.scrollHeight > box.clientHeight) box.tabIndex = 0;
    else box.removeAttribute("tabindex");
  }
}
addEventListener("load", accessible);
addEventListener("resize", accessible);
document.fonts?.ready.then(accessible);
