/* What the theme's pages lack for those who use them by keyboard or by ear. The theme makes some of it when a page
   is shown, or wide enough, so it is looked after from then on. */
"use strict";
(() => {
  const all = (selector) => document.querySelectorAll(selector);

  const mend = () => {
    all("pre > code, .md-typeset__scrollwrap, .equation").forEach((box) => {
      if (box.scrollWidth > box.clientWidth && !box.hasAttribute("tabindex")) box.tabIndex = 0; // keys scroll it
    });
    all(".md-code__nav:not([aria-label])").forEach((nav, k) => nav.setAttribute("aria-label", `Code block ${k + 1}`));
    all(".md-search:not([aria-label])").forEach((dialog) => dialog.setAttribute("aria-label", "Search"));
    all("nav.md-nav[aria-labelledby]").forEach((nav) => {
      const label = document.getElementById(nav.getAttribute("aria-labelledby"));
      const title = nav.querySelector(":scope > .md-nav__title");
      if (!label || !title || label.textContent.trim()) return;
      const name = document.createElement("span");
      name.className = "unseen";
      name.textContent = title.textContent.trim();
      label.append(name);
    });
  };

  new MutationObserver(mend).observe(document.body, {
    subtree: true, childList: true, attributes: true, attributeFilter: ["tabindex"],
  });
  addEventListener("resize", mend);
  mend();
})();
