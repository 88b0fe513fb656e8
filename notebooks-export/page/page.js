// SPDX-License-Identifier: GPL-3.0-or-later
"use strict";
(() => {
  const root = document.documentElement;

  for (const at of document.querySelectorAll("[data-tex]")) {
    if (typeof katex === "undefined") break;  // the source of the formula stays
    try {
      katex.render(at.dataset.tex, at, { displayMode: at.classList.contains("formula"), throwOnError: true });
    } catch (error) {
      console.error(`a formula could not be shown: ${error.message}`);
    }
  }

  const theme = document.getElementById("theme");
  theme.hidden = false;
  theme.addEventListener("click", () => {
    const dark = root.dataset.theme ? root.dataset.theme === "dark" : matchMedia("(prefers-color-scheme: dark)").matches;
    root.dataset.theme = dark ? "light" : "dark";
    theme.setAttribute("aria-pressed", String(!dark));
  });

  for (const tabs of document.querySelectorAll(".tabs")) {
    const buttons = [...tabs.querySelectorAll("[role=tab]")];
    const choose = (chosen, focus) => {
      for (const button of buttons) {
        const on = button === chosen;
        button.setAttribute("aria-selected", String(on));
        button.tabIndex = on ? 0 : -1;
        document.getElementById(button.getAttribute("aria-controls")).hidden = !on;
      }
      if (focus) chosen.focus();
    };
    buttons.forEach((button, i) => {
      button.addEventListener("click", () => choose(button, false));
      button.addEventListener("keydown", (event) => {
        const to = { ArrowRight: i + 1, ArrowLeft: i - 1, Home: 0, End: buttons.length - 1 }[event.key];
        if (to === undefined) return;
        event.preventDefault();
        choose(buttons[(to + buttons.length) % buttons.length], true);
      });
    });
    choose(buttons[0], false);
  }

  for (const button of document.querySelectorAll(".copy")) {
    button.hidden = false;
    button.addEventListener("click", async () => {
      const code = button.parentElement.querySelector("code");
      try {
        await navigator.clipboard.writeText(code.textContent);
        button.textContent = "Copied";
      } catch {
        getSelection().selectAllChildren(code);  // pages opened from a disk may not write to the clipboard
        button.textContent = "Selected: press Ctrl+C";
      }
      setTimeout(() => { button.textContent = "Copy"; }, 2500);
    });
  }
})();
