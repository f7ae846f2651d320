"use strict";
// The tree of parts and the tables. All text becomes text nodes, never markup.

function make(tag, attributes = {}, children = []) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith("on")) {
      element.addEventListener(name.slice(2), value);
    } else if (name in element && name !== "type" && name !== "list") {
      element[name] = value;
    } else {
      element.setAttribute(name, value);
    }
  }
  element.append(...children);
  return element;
}

// Hues a golden section of the circle apart, in tones that do not shout.
function usualColour(index) {
  const hue = (0.56 + 0.6180339887498949 * index) % 1;
  const channel = shift => {
    const k = (shift + 12 * hue) % 12;
    return Math.round(255 * (0.63 - 0.24 * Math.max(-1, Math.min(k - 3, 9 - k, 1))));
  };
  return [channel(0), channel(8), channel(4)];
}

function colourOf(code) { return [1, 3, 5].map(i => parseInt(code.slice(i, i + 2), 16)); }

function codeOf(colour) { return "#" + colour.map(x => x.toString(16).padStart(2, "0")).join(""); }

// From low (blue) to high (yellow), as even as one sees it: anchors of viridis.
function rampColour(share) {
  const anchors = [[68, 1, 84], [59, 82, 139], [33, 145, 140], [94, 201, 98], [253, 231, 37]];
  const at = Math.max(0, Math.min(1, share)) * 4, i = Math.min(3, Math.floor(at));
  return anchors[i].map((x, k) => Math.round(x + (at - i) * (anchors[i + 1][k] - x)));
}

class Tree {
  constructor(data, view, onChoose) {
    this.parts = data.parts.map((part, index) => ({...part, index, isShown: true, isOpen: false,
      own: part.colour ? colourOf(part.colour) : usualColour(index)}));
    this.labels = data.labels;
    this.view = view;
    this.onChoose = onChoose;
    this.chosen = null;
    this.partOfLabel = new Array(data.labels.length).fill(null);
    this.parts.forEach(part => part.labels.forEach(label => this.partOfLabel[label] = part));
    this.list = document.getElementById("parts");
    document.getElementById("show-all").onclick = () => this.show(() => true);
    document.getElementById("show-none").onclick = () => this.show(() => false);
    document.getElementById("filter").oninput = () => this.filter();
    this.fillColourChoice();
    this.fill();
    this.parts.forEach(part => this.paint(part));
  }

  fill() {
    this.list.replaceChildren();
    for (const part of this.parts) {
      part.box = make("input", {type: "checkbox", checked: part.isShown, ariaLabel: "Show " + part.name,
        onchange: event => this.show(other => other === part ? event.target.checked : other.isShown)});
      part.swatch = make("input", {type: "color", title: "Colour", value: codeOf(part.own), oninput: event => {
        part.own = colourOf(event.target.value);
        this.paint(part);
      }});
      const more = make("button", {className: "more", textContent: part.labels.length > 1 ? "\u25b8" : "", ariaLabel: "Patches",
        onclick: () => this.toggle(part, more)});
      part.item = make("li", {onclick: event => { if (event.target.tagName !== "INPUT" && event.target !== more) this.choose(part); },
        ondblclick: () => this.isolate(part), title: part.name + (part.kind ? ", " + part.kind : "") + "\nDouble click: this part alone"},
      [more, part.box, part.swatch, make("span", {className: "name", textContent: part.name}),
        make("span", {className: "kind", textContent: part.kind})]);
      this.list.append(part.item);
    }
  }

  toggle(part, more) {
    part.isOpen = !part.isOpen;
    more.textContent = part.isOpen ? "\u25be" : "\u25b8";
    if (!part.isOpen) {
      part.patches.forEach(item => item.remove());
      return;
    }
    part.patches = part.labels.map(label => make("li", {className: "patch"}, [make("span", {className: "name",
      textContent: this.labels[label]})]));
    part.item.after(...part.patches);
  }

  fillColourChoice() {
    const values = [...new Set(this.parts.flatMap(part => Object.keys(part.values || {})))];
    const kinds = [...new Set(this.parts.map(part => part.kind))];
    const choices = ["part", ...(kinds.length > 1 ? ["kind"] : []), ...values, "one colour"];
    const select = document.getElementById("colour-by");
    select.append(...choices.map(choice => make("option", {value: choice, textContent: choice})));
    select.onchange = () => {
      const present = this.parts.map(part => (part.values || {})[select.value]).filter(x => x !== undefined);
      const [low, high] = [Math.min(...present), Math.max(...present)];
      for (const part of this.parts) {
        const value = (part.values || {})[select.value];
        part.own = select.value === "part" ? (part.colour ? colourOf(part.colour) : usualColour(part.index))
          : select.value === "kind" ? usualColour(kinds.indexOf(part.kind))
          : select.value === "one colour" ? [150, 170, 190]
          : value === undefined ? [190, 190, 190] : rampColour(high > low ? (value - low) / (high - low) : 0);
        part.swatch.value = codeOf(part.own);
        this.paint(part);
      }
    };
  }

  paint(part, hovered = null) {
    const lit = part === this.chosen ? 0.35 : part === hovered ? 0.2 : 0;
    const colour = part.own.map((x, k) => Math.round(x + lit * ([255, 214, 102][k] - x)));
    part.labels.forEach(label => this.view.setLook(label, colour, part.isShown));
  }

  show(isShown) {
    for (const part of this.parts) {
      const now = isShown(part);
      if (now !== part.isShown) {
        part.isShown = now;
        part.box.checked = now;
        this.paint(part);
      }
    }
  }

  isolate(part) {
    const isAlone = part.isShown && this.parts.every(other => other === part || !other.isShown);
    this.show(other => isAlone || other === part);
  }

  choose(part) {
    const before = this.chosen;
    this.chosen = part;
    [before, part].filter(Boolean).forEach(other => {
      other.item.classList.toggle("chosen", other === part);
      this.paint(other);
    });
    if (part) {
      const item = part.item.getBoundingClientRect(), list = this.list.getBoundingClientRect();
      this.list.scrollTop += Math.min(0, item.top - list.top) + Math.max(0, item.bottom - list.bottom);  // and not the page
    }
    this.onChoose(part);
  }

  hover(part) {
    if (part !== this.hovered) {
      const before = this.hovered;
      this.hovered = part;
      [before, part].filter(Boolean).forEach(other => this.paint(other, part));
    }
  }

  filter() {
    const typed = document.getElementById("filter").value.toLowerCase();
    for (const part of this.parts) {
      part.item.hidden = !(part.name + " " + part.kind).toLowerCase().includes(typed);
      (part.isOpen ? part.patches : []).forEach(item => item.hidden = part.item.hidden);
    }
  }
}

class Tables {
  constructor(data, onGo) {
    this.sections = data.sections;
    this.onGo = onGo;
    this.tabs = document.getElementById("tabs");
    this.table = document.getElementById("table");
    this.chosenRow = null;
    this.onOpen = () => {};
    this.sections.forEach((section, index) => {
      const faults = section.rows.filter(row => row.finding).length;
      const count = faults || (section.counted ? section.rows.length : "");
      section.tab = make("button", {role: "tab", onclick: () => this.open(index), className: faults ? "faults" : ""},
        [section.title, ...(count === "" ? [] : [make("span", {className: "count", textContent: String(count)})])]);
      this.tabs.append(section.tab);
    });
    const withFaults = this.sections.findIndex(section => section.rows.some(row => row.finding));
    this.open(Math.max(0, withFaults));
  }

  open(index) {
    this.sections.forEach((section, i) => section.tab.setAttribute("aria-pressed", String(i === index)));
    this.opened = index;
    this.onOpen(index);
    const {note, columns, rows} = this.sections[index];
    const hasPlaces = rows.some(row => row.place || row.part !== undefined);
    this.table.replaceChildren(...(note ? [make("p", {className: "note", textContent: note})] : []));
    if (rows.length === 0) {
      return;
    }
    const head = make("tr", {}, [...columns, ...(hasPlaces ? [""] : [])].map(name => make("th", {textContent: name})));
    const body = rows.map(row => this.row(row, hasPlaces));
    this.table.append(make("table", {}, [make("thead", {}, columns.some(Boolean) ? [head] : []), make("tbody", {}, body)]));
  }

  row(row, hasPlaces) {
    const leads = row.place || row.part !== undefined;
    const cells = row.cells.map(cell => make("td", {textContent: cell,
      className: /^[\u2212-]?\d[\d.e+\u2212-]*( \S{1,4})?$/.test(cell) ? "number" : ""}));
    if (hasPlaces) {
      cells.push(make("td", {className: "go", textContent: leads ? "\u2192" : ""}));
    }
    const element = make("tr", {className: row.finding ? "finding" : ""}, cells);
    if (leads) {
      element.tabIndex = 0;
      element.onclick = () => this.go(row, element);
      element.onkeydown = event => { if (event.key === "Enter" || event.key === " ") { event.preventDefault(); this.go(row, element); } };
    }
    row.element = element;
    element.classList.toggle("chosen", row === this.chosenRow);
    return element;
  }

  go(row) {
    if (this.chosenRow && this.chosenRow.element) {
      this.chosenRow.element.classList.remove("chosen");
    }
    this.chosenRow = row;
    row.element.classList.add("chosen");
    this.onGo(row);
  }

  // Opens the table in which the row is.
  goTo(row) {
    this.open(this.sections.findIndex(section => section.rows.includes(row)));
    this.go(row);
    row.element.scrollIntoView({block: "center"});
  }
}
