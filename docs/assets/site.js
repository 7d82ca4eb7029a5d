/* What the theme's pages lack, above all for those who use them by keyboard or by ear. The theme makes some of it when
   a page is shown, or wide enough, so it is looked after from then on. */
"use strict";
(() => {
  const all = (selector) => document.querySelectorAll(selector);

  const mend = () => {
    all("pre > code, .md-typeset__scrollwrap, .equation").forEach((box) => {
      if (box.scrollWidth > box.clientWidth && !box.hasAttribute("tabindex")) box.tabIndex = 0; // keys scroll it
    });
    all(".md-code__nav:not([aria-label])").forEach((nav, k) => nav.setAttribute("aria-label", `Code block ${k + 1}`));
    all(".md-search:not([aria-label])").forEach((dialog) => dialog.setAttribute("aria-label", "Search"));
    all(".language-console [data-md-type=copy]:not([data-clipboard-text])").forEach((button) => {
      const lines = button.closest(".highlight").querySelector("code").textContent.split("\n");
      const isCommand = (k) => lines[k].startsWith("$ ") || (k > 0 && lines[k - 1].endsWith("\\") && isCommand(k - 1));
      const commands = lines.filter((_, k) => isCommand(k)).map((line) => line.replace(/^\$ /, ""));
      button.setAttribute("data-clipboard-text", commands.join("\n")); // without prompts and what is printed
    });
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
