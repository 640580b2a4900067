var me={define(i,e){globalThis.customElements.get(i)||globalThis.customElements.define(i,e)}};var oi=class extends Error{constructor(t,n=!1){super(t);this.isSilent=n}};var Wm="The kernel has ended. Run the cell again.",Ul=()=>Promise.reject(new oi("A notebook edits and saves its project in Python.")),Ol=class{constructor(e){this.model=e;this.isLive=!0;this.oneAtATime=!0;this.client=Math.random().toString(36).slice(2);this.waiting=new Map;this.count=0;this.ended=!1;this.opened=()=>this.send({ask:"open"});this.project=()=>this.opened();this.schema=Ul;this.text=Ul;this.newCase=Ul;this.save=Ul;this.receive=({id:e,error:t},[n])=>{let s=this.waiting.get(e);s&&(this.waiting.delete(e),t!==void 0||!n?s.failed(new oi(t??"The kernel sent no answer.")):s.done(new TextDecoder().decode(n)))};this.end=()=>{this.ended=!0;for(let{failed:e}of this.waiting.values())e(new oi(Wm));this.waiting.clear()};e.on("msg:custom",this.receive),e.on("comm:close",this.end),e.on("comm_live_update",this.end)}ask(e,{settings:t,case:n},s,r){return this.send({ask:"answer",question:{revision:e,settings:t,case:n,wants:s}},r)}keep(e,t){this.model.send({ask:"keep",view:e,answer:t})}close(){this.model.off("msg:custom",this.receive),this.model.off("comm:close",this.end),this.model.off("comm_live_update",this.end)}send(e,t){if(this.ended)return Promise.reject(new oi(Wm));if(t?.aborted)return Promise.reject(t.reason);let n=`${this.client} ${++this.count}`;return new Promise((s,r)=>{this.waiting.set(n,{done:o=>s(JSON.parse(o)),failed:r}),t?.addEventListener("abort",()=>{this.waiting.delete(n)&&r(t.reason)}),this.model.send({id:n,...e})})}};var Fl=()=>Promise.reject(new oi("There is no kernel.")),kl=class{constructor(e){this.kept=e;this.isLive=!1;this.project=async()=>this.kept.opened;this.schema=Fl;this.text=Fl;this.newCase=Fl;this.save=Fl}async ask(e,t,n){let{ok:s,problems:r,results:o}=this.kept.answer,a={ok:!1,problems:[],failure:"This result was not kept.",json:null};return{revision:e,ok:s,problems:r,results:n.map(({command:l})=>o.find(c=>c.command===l)??{command:l,...a})}}};var tb=["quick","exact","slow"],nb={quick:0,exact:40,slow:200},oa=i=>i.as??i.want.command,pd=i=>`draft of ${i}`,$m=({want:i,settings:e})=>JSON.stringify([i,e]),ib=({exact:i,slow:e})=>e?"slow":i?"exact":"quick",Bl=class{constructor(e,t,n){this.engine=e;this.state=t;this.wishes=n;this.problems=[];this.trouble="";this.results=new Map;this.underWay=null;this.asked={quick:-1,exact:-1,slow:-1};this.changedAt=0;this.seen=-1;this.listeners=new Set;this.isOld=e=>this.revisionOf(e)!==this.state.revision;t.subscribe(()=>this.next())}result(e){let t=this.newest(e);return t&&t.generation===this.state.generation&&t.outcome.ok?t.outcome.json:null}notes(e){let t=this.results.get(e);return t?.generation===this.state.generation?t.outcome.notes??[]:[]}failure(e){let t=this.results.get(e);return!t||t.generation!==this.state.generation||t.outcome.ok?"":t.outcome.failure||t.outcome.problems.map(n=>n.message).join(`
`)}missing(e){return this.problems.some(t=>t.severity==="error")?"The file has errors; see the messages above.":this.failure(e)||"Computing …"}revisionOf(e){let t=this.newest(e);return t&&t.generation===this.state.generation?t.revision:-1}get finished(){let e=this.wishes().filter(n=>n.as===void 0);if(this.underWay||!e.length||e.some(n=>this.results.get(oa(n))?.revision!==this.state.revision))return null;let t=e.map(n=>{let{hash:s,same:r,...o}=this.results.get(oa(n)).outcome;return o});return{revision:this.state.revision,ok:t.every(n=>n.ok),problems:this.problems,results:t}}again(){this.asked={quick:-1,exact:-1,slow:-1},this.next()}subscribe(e){return this.listeners.add(e),()=>this.listeners.delete(e)}next(){let{revision:e}=this.state,t=performance.now();if(e!==this.seen&&([this.seen,this.changedAt]=[e,t]),this.underWay){this.underWay.pace!=="quick"&&this.underWay.revision!==e&&this.underWay.end.abort();return}clearTimeout(this.restTimer);let n=tb.find(r=>this.asked[r]!==e);if(!n)return;let s=this.changedAt+nb[n]-t;n==="quick"||s<=0?this.send(n,e):this.restTimer=setTimeout(()=>this.next(),s)}async send(e,t){let n=this.wishes().filter(o=>ib(o)===e&&(e!=="exact"||!this.isKept(o))),{generation:s,change:r}=this.state;if(this.asked[e]=t,n.length){let{end:o}=this.underWay={pace:e,revision:t,end:new AbortController};try{let a=[...r.settings,...n.flatMap(l=>l.settings??[])];this.take(await this.engine.ask(t,{...r,settings:a},n.map(l=>this.unknown(l)),o.signal),n,s),this.trouble=""}catch(a){o.signal.aborted||(this.trouble=a instanceof oi?a.message:String(a))}if(this.underWay=null,!o.signal.aborted)for(let a of this.listeners)a()}(!this.trouble||this.state.revision!==t)&&this.next()}newest(e){let t=this.results.get(e),n=this.results.get(pd(e));return n?.outcome.ok&&(!t||n.generation>t.generation||n.revision>t.revision)?n:t}isKept(e){let t=this.results.get(oa(e)),{revision:n,generation:s}=this.state;return t?.revision===n&&t.generation===s&&t.asked===$m(e)}unknown(e){let t=this.results.get(oa(e))?.outcome.hash;return t?{...e.want,known:t}:e.want}take(e,t,n){if(n===this.state.generation){this.problems=e.problems;for(let s of e.results){let r=t.find(c=>c.want.command===s.command),o=r?oa(r):s.command,a=this.results.get(o);if(a&&a.generation===n&&a.revision>e.revision)continue;let l=s.same&&a?a.outcome.json:s.json;this.results.set(o,{revision:e.revision,generation:n,asked:r?$m(r):"",outcome:{...s,json:l}})}}}};var sb=350,Vl=class{constructor(e,t){this.engine=e;this.wanted=t;this.found=new Map;this.running=null;this.waiting=new Set;this.timer=0;this.listeners=new Set;this.isRunning=e=>this.running?.key===e;this.rest=()=>{clearTimeout(this.timer),this.timer=window.setTimeout(()=>this.next(),sb)}}result(e){let{outcome:t}=this.found.get(e)??{outcome:null};return t?.ok?t.json:null}failure(e){let{outcome:t}=this.found.get(e)??{outcome:null};return t&&!t.ok?t.failure||t.problems.map(n=>n.message).join(`
`):""}isOld(e){let t=this.wanted().find(n=>n.key===e);return t!==void 0&&this.found.get(e)?.identity!==zl(t)}takesLong(e){let t=this.wanted().find(r=>r.key===e),n=this.found.get(e);if(t?.patience===void 0||this.waiting.has(e))return!1;let s=n?.identity===zl(t);return t.patience?s&&n?.outcome===null:!s}waitFor(e){this.waiting.add(e),this.found.delete(e),this.next()}yield(){this.running?.stop.abort(),this.rest()}subscribe(e){return this.listeners.add(e),()=>this.listeners.delete(e)}next(){if(this.running)return;let e=this.wanted().find(t=>(t.patience!==0||this.waiting.has(t.key))&&this.found.get(t.key)?.identity!==zl(t));e&&this.ask(e,zl(e))}async ask({key:e,change:t,want:n,patience:s},r){let o=new AbortController,a=!1,l=s&&!this.waiting.has(e)?window.setTimeout(()=>{a=!0,o.abort()},s):0;this.running={key:e,identity:r,stop:o},this.notify();try{let c=await this.engine.ask(0,t,[n],o.signal);this.found.set(e,{identity:r,outcome:c.results[0]??qm(c.problems[0]?.message??"")})}catch(c){a?this.found.set(e,{identity:r,outcome:null}):o.signal.aborted||this.found.set(e,{identity:r,outcome:qm(c instanceof oi?c.message:String(c))})}clearTimeout(l),o.signal.aborted||this.waiting.delete(e),this.running=null,this.notify(),o.signal.aborted&&!a?this.rest():this.next()}notify(){for(let e of this.listeners)e()}},zl=({change:i,want:e})=>JSON.stringify([i,e]),qm=i=>({command:"",ok:!1,problems:[],failure:i,json:null});var Gl=class{constructor(){this.theme=matchMedia("(prefers-color-scheme: dark)").matches?"dark":"light";this.frequencyUnit="Hz";this.logarithmicFrequency=!1;this.decibel=!1;this.logarithmicAmplitude=!0;this.shown={kind:"mode",number:1};this.damped=!1;this.playing=!matchMedia("(prefers-reduced-motion: reduce)").matches;this.share=.04;this.speed=.5;this.phase=0;this.traces=!1;this.ghost="edges";this.colouring="none";this.cursor=null;this.drawn=[];this.pins=[];this.leftTab="sliders";this.compared=new Map;this.quantity="";this.table=null;this.notice="";this.listeners=new Set}set(e){Object.assign(this,e);for(let t of this.listeners)t()}subscribe(e){return this.listeners.add(e),()=>this.listeners.delete(e)}};function Xm(i,e,t=!1){if(i===0)return"0";let n=Math.abs(i),s=n>=1e6||n<1e-4?i.toExponential(e-1):i.toPrecision(e);return t||!/[.e]/.test(s)?s:s.includes("e")?s.replace(/\.?0*e\+?/,"e"):s.replace(/\.?0+$/,"")}var Ym=(i,e)=>e.findLast(([t])=>i>=t*(1-1e-9))??e[0];var Zm=2*Math.PI,Li={Hz:1/Zm,rpm:60/Zm,"rad/s":1};function je(i,e=4){return i==null||Number.isNaN(i)?"–":Number.isFinite(i)?Xm(i,e).replace("-","−"):i>0?"∞":"−∞"}var jm=[[1e-9,"n"],[1e-6,"µ"],[.001,"m"],[1,""],[1e3,"k"],[1e6,"M"]],rb=new Set(["m","m/s","m/s^2","m/s2","m/s²","rad","rad/s","rad/s^2","s"]),ob=/^(m|N|rad|W|J|Pa|s)\b/,ab={m:"displacement",rad:"rotation","m/s":"velocity","rad/s":"angular velocity","m/s^2":"acceleration","m/s2":"acceleration","m/s²":"acceleration","rad/s^2":"angular acceleration","rad/s2":"angular acceleration","rad/s²":"angular acceleration",N:"force","N m":"moment"},Kr=i=>ab[i]??i;function Hl(i,e){let t=e.replace("^2","²").replace("s2","s²");if(!ob.test(e)||!(i>0))return{factor:1,unit:t};let[n,s]=Ym(i,rb.has(e)?jm.filter(([r])=>r<=1):jm);return{factor:1/n,unit:s+t}}function Wl(i,e,{level:t,level_factor:n=1}={}){let s=Hl(i*n,e);return{factor:s.factor*n,unit:t?`${s.unit} ${t}`:s.unit}}var Jm=i=>i?lb[i]:1,lb={"0-p":1,"p-p":2,rms:Math.SQRT1_2};function Qi(i,e,t=4){if(i==null||!Number.isFinite(i))return je(i);let n=Hl(Math.abs(i),e);return`${je(i*n.factor,t)} ${n.unit}`.trim()}var es=(i,e,t=4)=>i===null?"–":`${je(i*Li[e],t)} ${e}`;function kn(i){let e=i.trim().match(/^"?\s*([-+−]?(?:\d[\d_]*\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*([^"]*?)\s*"?$/);if(!e)return null;let t=Number(e[1].replaceAll("_","").replace("−","-"));return Number.isFinite(t)?{value:t,unit:e[2]}:null}var mr=(i,e)=>{let t=String(Number(i.toPrecision(6)));return e?`"${t} ${e}"`:t};var cb=["requirements","limits","limit_lines","clearances","operation"],vi=i=>[...i.index.byPath.values()].some(({path:e})=>{let[t,n]=e[0]==="cases"?e.slice(2):e;return cb.includes(String(t))&&(t!=="operation"||n==="limits")}),Km=i=>i.case?`case ${i.case}`:"the base model",hb=i=>i.requirements.some(e=>e.judged&&!e.met);function Qm(i){let{asker:e,state:t}=i,n=e.problems.filter(r=>r.severity==="error");if(n.length)return{state:"error",words:n.length===1?"1 error in the file":`${n.length} errors in the file`,old:!1};let s=e.result("verdict");if(s){let r=s.cases.find(g=>g.case===t.case)??s.cases[0],o=r?.requirements??[],a=o.filter(g=>g.judged&&!g.met),l=o.filter(g=>!g.judged),c=e.isOld("verdict"),h=l.length?`${l.length} of ${o.length} requirements not judged`:"",u=[...a.length?[`${a.length} of ${o.length} requirements violated`]:[],...h?[h]:[]].join(", ");if(!r?.met&&r?.decides!==!1)return{state:"violated",words:u||"not met",old:c};let d=s.cases.find(g=>g!==r&&g.decides&&!g.met),f=d?`${hb(d)?"violated":"not judged"} in ${Km(d)}`:"",p=`${u} here, not binding`;if(f)return{state:"violated",words:r.met?`met here, ${f}`:`${f}; ${p}`,old:c};if(!r.met)return{state:"unbinding",words:p,old:c};let _=s.least_margin,m=_&&_.case!==r.case?` in ${Km(_)}`:"";return{state:"met",words:`all ${o.length} requirements met${_?`, least margin ${je(_.margin,4)}${m}`:""}`,old:c}}return vi(i)?{state:"unknown",words:e.failure("verdict")?"not judged":"judging",old:!e.failure("verdict")}:{state:"none",words:"no requirements",old:!1}}var $l=globalThis,Xl=$l.ShadowRoot&&($l.ShadyCSS===void 0||$l.ShadyCSS.nativeShadow)&&"adoptedStyleSheets"in Document.prototype&&"replace"in CSSStyleSheet.prototype,tg=Symbol(),eg=new WeakMap,ql=class{constructor(e,t,n){if(this._$cssResult$=!0,n!==tg)throw Error("CSSResult is not constructable. Use `unsafeCSS` or `css` instead.");this.cssText=e,this.t=t}get styleSheet(){let e=this.o,t=this.t;if(Xl&&e===void 0){let n=t!==void 0&&t.length===1;n&&(e=eg.get(t)),e===void 0&&((this.o=e=new CSSStyleSheet).replaceSync(this.cssText),n&&eg.set(t,e))}return e}toString(){return this.cssText}},ng=i=>new ql(typeof i=="string"?i:i+"",void 0,tg);var ig=(i,e)=>{if(Xl)i.adoptedStyleSheets=e.map(t=>t instanceof CSSStyleSheet?t:t.styleSheet);else for(let t of e){let n=document.createElement("style"),s=$l.litNonce;s!==void 0&&n.setAttribute("nonce",s),n.textContent=t.cssText,i.appendChild(n)}},md=Xl?i=>i:i=>i instanceof CSSStyleSheet?(e=>{let t="";for(let n of e.cssRules)t+=n.cssText;return ng(t)})(i):i;var{is:ub,defineProperty:db,getOwnPropertyDescriptor:fb,getOwnPropertyNames:pb,getOwnPropertySymbols:mb,getPrototypeOf:gb}=Object,Yl=globalThis,sg=Yl.trustedTypes,_b=sg?sg.emptyScript:"",yb=Yl.reactiveElementPolyfillSupport,aa=(i,e)=>i,gd={toAttribute(i,e){switch(e){case Boolean:i=i?_b:null;break;case Object:case Array:i=i==null?i:JSON.stringify(i)}return i},fromAttribute(i,e){let t=i;switch(e){case Boolean:t=i!==null;break;case Number:t=i===null?null:Number(i);break;case Object:case Array:try{t=JSON.parse(i)}catch{t=null}}return t}},og=(i,e)=>!ub(i,e),rg={attribute:!0,type:String,converter:gd,reflect:!1,useDefault:!1,hasChanged:og};Symbol.metadata??=Symbol("metadata"),Yl.litPropertyMetadata??=new WeakMap;var _s=class extends HTMLElement{static addInitializer(e){this._$Ei(),(this.l??=[]).push(e)}static get observedAttributes(){return this.finalize(),this._$Eh&&[...this._$Eh.keys()]}static createProperty(e,t=rg){if(t.state&&(t.attribute=!1),this._$Ei(),this.prototype.hasOwnProperty(e)&&((t=Object.create(t)).wrapped=!0),this.elementProperties.set(e,t),!t.noAccessor){let n=Symbol(),s=this.getPropertyDescriptor(e,n,t);s!==void 0&&db(this.prototype,e,s)}}static getPropertyDescriptor(e,t,n){let{get:s,set:r}=fb(this.prototype,e)??{get(){return this[t]},set(o){this[t]=o}};return{get:s,set(o){let a=s?.call(this);r?.call(this,o),this.requestUpdate(e,a,n)},configurable:!0,enumerable:!0}}static getPropertyOptions(e){return this.elementProperties.get(e)??rg}static _$Ei(){if(this.hasOwnProperty(aa("elementProperties")))return;let e=gb(this);e.finalize(),e.l!==void 0&&(this.l=[...e.l]),this.elementProperties=new Map(e.elementProperties)}static finalize(){if(this.hasOwnProperty(aa("finalized")))return;if(this.finalized=!0,this._$Ei(),this.hasOwnProperty(aa("properties"))){let t=this.properties,n=[...pb(t),...mb(t)];for(let s of n)this.createProperty(s,t[s])}let e=this[Symbol.metadata];if(e!==null){let t=litPropertyMetadata.get(e);if(t!==void 0)for(let[n,s]of t)this.elementProperties.set(n,s)}this._$Eh=new Map;for(let[t,n]of this.elementProperties){let s=this._$Eu(t,n);s!==void 0&&this._$Eh.set(s,t)}this.elementStyles=this.finalizeStyles(this.styles)}static finalizeStyles(e){let t=[];if(Array.isArray(e)){let n=new Set(e.flat(1/0).reverse());for(let s of n)t.unshift(md(s))}else e!==void 0&&t.push(md(e));return t}static _$Eu(e,t){let n=t.attribute;return n===!1?void 0:typeof n=="string"?n:typeof e=="string"?e.toLowerCase():void 0}constructor(){super(),this._$Ep=void 0,this.isUpdatePending=!1,this.hasUpdated=!1,this._$Em=null,this._$Ev()}_$Ev(){this._$ES=new Promise(e=>this.enableUpdating=e),this._$AL=new Map,this._$E_(),this.requestUpdate(),this.constructor.l?.forEach(e=>e(this))}addController(e){(this._$EO??=new Set).add(e),this.renderRoot!==void 0&&this.isConnected&&e.hostConnected?.()}removeController(e){this._$EO?.delete(e)}_$E_(){let e=new Map,t=this.constructor.elementProperties;for(let n of t.keys())this.hasOwnProperty(n)&&(e.set(n,this[n]),delete this[n]);e.size>0&&(this._$Ep=e)}createRenderRoot(){let e=this.shadowRoot??this.attachShadow(this.constructor.shadowRootOptions);return ig(e,this.constructor.elementStyles),e}connectedCallback(){this.renderRoot??=this.createRenderRoot(),this.enableUpdating(!0),this._$EO?.forEach(e=>e.hostConnected?.())}enableUpdating(e){}disconnectedCallback(){this._$EO?.forEach(e=>e.hostDisconnected?.())}attributeChangedCallback(e,t,n){this._$AK(e,n)}_$ET(e,t){let n=this.constructor.elementProperties.get(e),s=this.constructor._$Eu(e,n);if(s!==void 0&&n.reflect===!0){let r=(n.converter?.toAttribute!==void 0?n.converter:gd).toAttribute(t,n.type);this._$Em=e,r==null?this.removeAttribute(s):this.setAttribute(s,r),this._$Em=null}}_$AK(e,t){let n=this.constructor,s=n._$Eh.get(e);if(s!==void 0&&this._$Em!==s){let r=n.getPropertyOptions(s),o=typeof r.converter=="function"?{fromAttribute:r.converter}:r.converter?.fromAttribute!==void 0?r.converter:gd;this._$Em=s;let a=o.fromAttribute(t,r.type);this[s]=a??this._$Ej?.get(s)??a,this._$Em=null}}requestUpdate(e,t,n,s=!1,r){if(e!==void 0){let o=this.constructor;if(s===!1&&(r=this[e]),n??=o.getPropertyOptions(e),!((n.hasChanged??og)(r,t)||n.useDefault&&n.reflect&&r===this._$Ej?.get(e)&&!this.hasAttribute(o._$Eu(e,n))))return;this.C(e,t,n)}this.isUpdatePending===!1&&(this._$ES=this._$EP())}C(e,t,{useDefault:n,reflect:s,wrapped:r},o){n&&!(this._$Ej??=new Map).has(e)&&(this._$Ej.set(e,o??t??this[e]),r!==!0||o!==void 0)||(this._$AL.has(e)||(this.hasUpdated||n||(t=void 0),this._$AL.set(e,t)),s===!0&&this._$Em!==e&&(this._$Eq??=new Set).add(e))}async _$EP(){this.isUpdatePending=!0;try{await this._$ES}catch(t){Promise.reject(t)}let e=this.scheduleUpdate();return e!=null&&await e,!this.isUpdatePending}scheduleUpdate(){return this.performUpdate()}performUpdate(){if(!this.isUpdatePending)return;if(!this.hasUpdated){if(this.renderRoot??=this.createRenderRoot(),this._$Ep){for(let[s,r]of this._$Ep)this[s]=r;this._$Ep=void 0}let n=this.constructor.elementProperties;if(n.size>0)for(let[s,r]of n){let{wrapped:o}=r,a=this[s];o!==!0||this._$AL.has(s)||a===void 0||this.C(s,void 0,r,a)}}let e=!1,t=this._$AL;try{e=this.shouldUpdate(t),e?(this.willUpdate(t),this._$EO?.forEach(n=>n.hostUpdate?.()),this.update(t)):this._$EM()}catch(n){throw e=!1,this._$EM(),n}e&&this._$AE(t)}willUpdate(e){}_$AE(e){this._$EO?.forEach(t=>t.hostUpdated?.()),this.hasUpdated||(this.hasUpdated=!0,this.firstUpdated(e)),this.updated(e)}_$EM(){this._$AL=new Map,this.isUpdatePending=!1}get updateComplete(){return this.getUpdateComplete()}getUpdateComplete(){return this._$ES}shouldUpdate(e){return!0}update(e){this._$Eq&&=this._$Eq.forEach(t=>this._$ET(t,this[t])),this._$EM()}updated(e){}firstUpdated(e){}};_s.elementStyles=[],_s.shadowRootOptions={mode:"open"},_s[aa("elementProperties")]=new Map,_s[aa("finalized")]=new Map,yb?.({ReactiveElement:_s}),(Yl.reactiveElementVersions??=[]).push("2.1.2");var yd=globalThis,ag=i=>i,Zl=yd.trustedTypes,lg=Zl?Zl.createPolicy("lit-html",{createHTML:i=>i}):void 0,xd="$lit$",ys=`lit$${Math.random().toFixed(9).slice(2)}$`,vd="?"+ys,xb=`<${vd}>`,yr=document,ca=()=>yr.createComment(""),ha=i=>i===null||typeof i!="object"&&typeof i!="function",bd=Array.isArray,pg=i=>bd(i)||typeof i?.[Symbol.iterator]=="function",_d=`[ 	
\f\r]`,la=/<(?:(!--|\/[^a-zA-Z])|(\/?[a-zA-Z][^>\s]*)|(\/?$))/g,cg=/-->/g,hg=/>/g,gr=RegExp(`>|${_d}(?:([^\\s"'>=/]+)(${_d}*=${_d}*(?:[^ 	
\f\r"'\`<>=]|("|')|))|$)`,"g"),ug=/'/g,dg=/"/g,mg=/^(?:script|style|textarea|title)$/i,Sd=i=>(e,...t)=>({_$litType$:i,strings:e,values:t}),ae=Sd(1),eo=Sd(2),GP=Sd(3),xr=Symbol.for("lit-noChange"),Ue=Symbol.for("lit-nothing"),fg=new WeakMap,_r=yr.createTreeWalker(yr,129);function gg(i,e){if(!bd(i)||!i.hasOwnProperty("raw"))throw Error("invalid template strings array");return lg!==void 0?lg.createHTML(e):e}var _g=(i,e)=>{let t=i.length-1,n=[],s,r=e===2?"<svg>":e===3?"<math>":"",o=la;for(let a=0;a<t;a++){let l=i[a],c,h,u=-1,d=0;for(;d<l.length&&(o.lastIndex=d,h=o.exec(l),h!==null);)d=o.lastIndex,o===la?h[1]==="!--"?o=cg:h[1]!==void 0?o=hg:h[2]!==void 0?(mg.test(h[2])&&(s=RegExp("</"+h[2],"g")),o=gr):h[3]!==void 0&&(o=gr):o===gr?h[0]===">"?(o=s??la,u=-1):h[1]===void 0?u=-2:(u=o.lastIndex-h[2].length,c=h[1],o=h[3]===void 0?gr:h[3]==='"'?dg:ug):o===dg||o===ug?o=gr:o===cg||o===hg?o=la:(o=gr,s=void 0);let f=o===gr&&i[a+1].startsWith("/>")?" ":"";r+=o===la?l+xb:u>=0?(n.push(c),l.slice(0,u)+xd+l.slice(u)+ys+f):l+ys+(u===-2?a:f)}return[gg(i,r+(i[t]||"<?>")+(e===2?"</svg>":e===3?"</math>":"")),n]},ua=class i{constructor({strings:e,_$litType$:t},n){let s;this.parts=[];let r=0,o=0,a=e.length-1,l=this.parts,[c,h]=_g(e,t);if(this.el=i.createElement(c,n),_r.currentNode=this.el.content,t===2||t===3){let u=this.el.content.firstChild;u.replaceWith(...u.childNodes)}for(;(s=_r.nextNode())!==null&&l.length<a;){if(s.nodeType===1){if(s.hasAttributes())for(let u of s.getAttributeNames())if(u.endsWith(xd)){let d=h[o++],f=s.getAttribute(u).split(ys),p=/([.?@])?(.*)/.exec(d);l.push({type:1,index:r,name:p[2],strings:f,ctor:p[1]==="."?Jl:p[1]==="?"?Kl:p[1]==="@"?Ql:br}),s.removeAttribute(u)}else u.startsWith(ys)&&(l.push({type:6,index:r}),s.removeAttribute(u));if(mg.test(s.tagName)){let u=s.textContent.split(ys),d=u.length-1;if(d>0){s.textContent=Zl?Zl.emptyScript:"";for(let f=0;f<d;f++)s.append(u[f],ca()),_r.nextNode(),l.push({type:2,index:++r});s.append(u[d],ca())}}}else if(s.nodeType===8)if(s.data===vd)l.push({type:2,index:r});else{let u=-1;for(;(u=s.data.indexOf(ys,u+1))!==-1;)l.push({type:7,index:r}),u+=ys.length-1}r++}}static createElement(e,t){let n=yr.createElement("template");return n.innerHTML=e,n}};function vr(i,e,t=i,n){if(e===xr)return e;let s=n!==void 0?t._$Co?.[n]:t._$Cl,r=ha(e)?void 0:e._$litDirective$;return s?.constructor!==r&&(s?._$AO?.(!1),r===void 0?s=void 0:(s=new r(i),s._$AT(i,t,n)),n!==void 0?(t._$Co??=[])[n]=s:t._$Cl=s),s!==void 0&&(e=vr(i,s._$AS(i,e.values),s,n)),e}var jl=class{constructor(e,t){this._$AV=[],this._$AN=void 0,this._$AD=e,this._$AM=t}get parentNode(){return this._$AM.parentNode}get _$AU(){return this._$AM._$AU}u(e){let{el:{content:t},parts:n}=this._$AD,s=(e?.creationScope??yr).importNode(t,!0);_r.currentNode=s;let r=_r.nextNode(),o=0,a=0,l=n[0];for(;l!==void 0;){if(o===l.index){let c;l.type===2?c=new Qr(r,r.nextSibling,this,e):l.type===1?c=new l.ctor(r,l.name,l.strings,this,e):l.type===6&&(c=new ec(r,this,e)),this._$AV.push(c),l=n[++a]}o!==l?.index&&(r=_r.nextNode(),o++)}return _r.currentNode=yr,s}p(e){let t=0;for(let n of this._$AV)n!==void 0&&(n.strings!==void 0?(n._$AI(e,n,t),t+=n.strings.length-2):n._$AI(e[t])),t++}},Qr=class i{get _$AU(){return this._$AM?._$AU??this._$Cv}constructor(e,t,n,s){this.type=2,this._$AH=Ue,this._$AN=void 0,this._$AA=e,this._$AB=t,this._$AM=n,this.options=s,this._$Cv=s?.isConnected??!0}get parentNode(){let e=this._$AA.parentNode,t=this._$AM;return t!==void 0&&e?.nodeType===11&&(e=t.parentNode),e}get startNode(){return this._$AA}get endNode(){return this._$AB}_$AI(e,t=this){e=vr(this,e,t),ha(e)?e===Ue||e==null||e===""?(this._$AH!==Ue&&this._$AR(),this._$AH=Ue):e!==this._$AH&&e!==xr&&this._(e):e._$litType$!==void 0?this.$(e):e.nodeType!==void 0?this.T(e):pg(e)?this.k(e):this._(e)}O(e){return this._$AA.parentNode.insertBefore(e,this._$AB)}T(e){this._$AH!==e&&(this._$AR(),this._$AH=this.O(e))}_(e){this._$AH!==Ue&&ha(this._$AH)?this._$AA.nextSibling.data=e:this.T(yr.createTextNode(e)),this._$AH=e}$(e){let{values:t,_$litType$:n}=e,s=typeof n=="number"?this._$AC(e):(n.el===void 0&&(n.el=ua.createElement(gg(n.h,n.h[0]),this.options)),n);if(this._$AH?._$AD===s)this._$AH.p(t);else{let r=new jl(s,this),o=r.u(this.options);r.p(t),this.T(o),this._$AH=r}}_$AC(e){let t=fg.get(e.strings);return t===void 0&&fg.set(e.strings,t=new ua(e)),t}k(e){bd(this._$AH)||(this._$AH=[],this._$AR());let t=this._$AH,n,s=0;for(let r of e)s===t.length?t.push(n=new i(this.O(ca()),this.O(ca()),this,this.options)):n=t[s],n._$AI(r),s++;s<t.length&&(this._$AR(n&&n._$AB.nextSibling,s),t.length=s)}_$AR(e=this._$AA.nextSibling,t){for(this._$AP?.(!1,!0,t);e!==this._$AB;){let n=ag(e).nextSibling;ag(e).remove(),e=n}}setConnected(e){this._$AM===void 0&&(this._$Cv=e,this._$AP?.(e))}},br=class{get tagName(){return this.element.tagName}get _$AU(){return this._$AM._$AU}constructor(e,t,n,s,r){this.type=1,this._$AH=Ue,this._$AN=void 0,this.element=e,this.name=t,this._$AM=s,this.options=r,n.length>2||n[0]!==""||n[1]!==""?(this._$AH=Array(n.length-1).fill(new String),this.strings=n):this._$AH=Ue}_$AI(e,t=this,n,s){let r=this.strings,o=!1;if(r===void 0)e=vr(this,e,t,0),o=!ha(e)||e!==this._$AH&&e!==xr,o&&(this._$AH=e);else{let a=e,l,c;for(e=r[0],l=0;l<r.length-1;l++)c=vr(this,a[n+l],t,l),c===xr&&(c=this._$AH[l]),o||=!ha(c)||c!==this._$AH[l],c===Ue?e=Ue:e!==Ue&&(e+=(c??"")+r[l+1]),this._$AH[l]=c}o&&!s&&this.j(e)}j(e){e===Ue?this.element.removeAttribute(this.name):this.element.setAttribute(this.name,e??"")}},Jl=class extends br{constructor(){super(...arguments),this.type=3}j(e){this.element[this.name]=e===Ue?void 0:e}},Kl=class extends br{constructor(){super(...arguments),this.type=4}j(e){this.element.toggleAttribute(this.name,!!e&&e!==Ue)}},Ql=class extends br{constructor(e,t,n,s,r){super(e,t,n,s,r),this.type=5}_$AI(e,t=this){if((e=vr(this,e,t,0)??Ue)===xr)return;let n=this._$AH,s=e===Ue&&n!==Ue||e.capture!==n.capture||e.once!==n.once||e.passive!==n.passive,r=e!==Ue&&(n===Ue||s);s&&this.element.removeEventListener(this.name,this,n),r&&this.element.addEventListener(this.name,this,e),this._$AH=e}handleEvent(e){typeof this._$AH=="function"?this._$AH.call(this.options?.host??this.element,e):this._$AH.handleEvent(e)}},ec=class{constructor(e,t,n){this.element=e,this.type=6,this._$AN=void 0,this._$AM=t,this.options=n}get _$AU(){return this._$AM._$AU}_$AI(e){vr(this,e)}},yg={M:xd,P:ys,A:vd,C:1,L:_g,R:jl,D:pg,V:vr,I:Qr,H:br,N:Kl,U:Ql,B:Jl,F:ec},vb=yd.litHtmlPolyfillSupport;vb?.(ua,Qr),(yd.litHtmlVersions??=[]).push("3.3.3");var xg=(i,e,t)=>{let n=t?.renderBefore??e,s=n._$litPart$;if(s===void 0){let r=t?.renderBefore??null;n._$litPart$=s=new Qr(e.insertBefore(ca(),r),r,void 0,t??{})}return s._$AI(i),s};var Md=globalThis,Hs=class extends _s{constructor(){super(...arguments),this.renderOptions={host:this},this._$Do=void 0}createRenderRoot(){let e=super.createRenderRoot();return this.renderOptions.renderBefore??=e.firstChild,e}update(e){let t=this.render();this.hasUpdated||(this.renderOptions.isConnected=this.isConnected),super.update(e),this._$Do=xg(t,this.renderRoot,this.renderOptions)}connectedCallback(){super.connectedCallback(),this._$Do?.setConnected(!0)}disconnectedCallback(){super.disconnectedCallback(),this._$Do?.setConnected(!1)}render(){return xr}};Hs._$litElement$=!0,Hs.finalized=!0,Md.litElementHydrateSupport?.({LitElement:Hs});var bb=Md.litElementPolyfillSupport;bb?.({LitElement:Hs});(Md.litElementVersions??=[]).push("4.2.2");function vg(i){return new tc(i).file()}function*wd(i){for(let e of i)yield e,yield*wd(e.children)}var Ws=i=>i.map(e=>/^[\w-]+$/.test(e)?e:`"${e.replace(/["\\]/g,"\\$&")}"`).join(".");function nc(i){return new tc(i).key()}var tc=class{constructor(e){this.text=e;this.at=0}file(){let e=[],t=null;for(;this.at<this.text.length;){this.skipBlank();let n=this.at;if(this.text[this.at]==="[")t=this.header(n),e.push(t);else if(this.at<this.text.length){let s=this.pair(t?.path??[]);s&&(t?t.children:e).push(s),t&&(t.to=this.at)}this.skipLine(),this.at===n&&this.at++}return e}key(){let e=[];for(;;){this.skipSpaces();let t=this.text[this.at];if(t==='"'||t==="'")e.push(this.quoted());else{let n=this.match(/[\w\-]+/y);if(!n)break;e.push(n)}if(this.skipSpaces(),this.text[this.at]!==".")break;this.at++}return e}header(e){this.match(/\[+/y);let t=this.key();return this.match(/\s*\]+/y),{path:t,from:this.at,to:this.at,keyFrom:e,kind:"table",raw:"",children:[]}}pair(e){let t=this.at,n=this.key();return this.skipSpaces(),!n.length||this.text[this.at]!=="="?null:(this.at++,this.skipSpaces(),this.value([...e,...n],t))}value(e,t){let n=this.at,s=this.text[n],r="other",o=[];if(s==="[")[r,o]=["array",this.array(e)];else if(s==="{")[r,o]=["table",this.inlineTable(e)];else if(s==='"'||s==="'"){let a=this.quoted();r=/^\s*[-+]?(\d|\.\d)/.test(a)&&!/^\d+[\w-]*:/.test(a)?"number":"text"}else{let a=this.match(/[^\s,\]}#]+/y)??"";r=/^[-+]?(\d|\.\d|inf|nan)/.test(a)?"number":"other"}return{path:e,from:n,to:this.at,keyFrom:t,kind:r,raw:this.text.slice(n,this.at),children:o}}array(e){let t=[];for(this.at++;this.skipBlank(),!(this.at>=this.text.length||this.text[this.at]==="]");){let n=this.at;if(t.push(this.value([...e,String(t.length)],this.at)),this.skipBlank(),this.text[this.at]===","&&this.at++,this.at===n)break}return this.at++,t}inlineTable(e){let t=[];for(this.at++;this.skipBlank(),!(this.at>=this.text.length||this.text[this.at]==="}");){let n=this.pair(e);if(!n)break;t.push(n),this.skipBlank(),this.text[this.at]===","&&this.at++}return this.at++,t}quoted(){let e=this.text[this.at],t=e.repeat(3);if(this.text.startsWith(t,this.at)){let r=this.text.indexOf(t,this.at+3),o=this.at+3;return this.at=r<0?this.text.length:r+3,this.text.slice(o,r<0?void 0:r)}let s=this.match(e==='"'?/"(?:[^"\\\n]|\\.)*"?/y:/'[^'\n]*'?/y).replace(/^["']|["']$/g,"");return e==='"'?s.replace(/\\(["\\])/g,"$1"):s}skipSpaces(){this.match(/[ \t]*/y)}skipBlank(){this.match(/(?:\s|#[^\n]*)*/y)}skipLine(){this.match(/[^\n]*\n?/y)}match(e){e.lastIndex=this.at;let t=e.exec(this.text);return t?(this.at=e.lastIndex,t[0]):null}};var Sb=["x","y","z"];function Mb(i,e){let t=[...i.path];if(t[0]==="parameters"||t[0]==="trivet")return null;if(t[0]==="tables"){if(t[2]!=="rows"||t[3]===void 0)return null;let r=e.get(t.slice(0,4).join("\0")),o=r?.children.find(a=>a.path.at(-1)==="name");if(!o)return null;t=[t[1],o.raw.slice(1,-1),...t.slice(4)]}let s=i.path.map((r,o)=>e.get(i.path.slice(0,o+1).join("\0"))).filter(r=>r?.kind==="array").filter(r=>r.path[0]!=="tables"||r.path.length>3);if(s.length>1)return null;if(s.length===1){if(s[0].children.length!==3||s[0]!==e.get(i.path.slice(0,-1).join("\0")))return null;t[t.length-1]=Sb[Number(t.at(-1))]}return Ws(t)}function Ed(i,e,t){let n=e?Ws(["cases",e,...nc(i)]):i;return t.numbers.has(n)?n:i}function bg(i){let e=vg(i),t=new Map;for(let s of wd(e))t.set(s.path.join("\0"),s);let n=new Map;for(let s of t.values()){let r=s.kind==="number"?Mb(s,t):null;r&&n.set(r,s)}return{entries:e,byPath:t,numbers:n}}var da=({byPath:i})=>["",...new Set([...i.values()].filter(e=>e.path[0]==="cases"&&e.path.length>1).map(e=>e.path[1]))];function Sg(i,e){let t=[];for(let n of i.keys())for(let s of n.startsWith("cases.")?[]:da(e)){let r=Ed(n,s,e),o=e.numbers.get(r);r!==n&&o&&!i.has(r)&&t.push([r,o.raw])}return t}function wb(i,e,t){return e.settings.get(i)??t.numbers.get(i)?.raw??null}var to=(i,e,t)=>{let n=wb(i,e,t);return n===null?null:kn(n)};var ic=class{constructor(e,t,n,s,r,o){this.engine=e;this.project=t;this.state=n;this.display=s;this.asker=r;this.beside=o;this.schema=null;this.file=null}get cases(){return da(this.index)}get index(){return this.state.index}},vn=class extends Hs{constructor(){super(...arguments);this.unsubscribe=[]}static{this.properties={app:{attribute:!1}}}createRenderRoot(){return this}connectedCallback(){super.connectedCallback();let t=()=>this.requestUpdate(),{state:n,display:s,asker:r,file:o}=this.app;this.unsubscribe=[n,s,r,...o?[o]:[]].map(a=>a.subscribe(t))}disconnectedCallback(){super.disconnectedCallback();for(let t of this.unsubscribe)t()}};var Mg={text:"\0",settings:new Map},sc=class{constructor(){this.design={text:"",settings:new Map};this.case="";this.selection=null;this.revision=0;this.generation=0;this.past=[];this.future=[];this.saved=this.design;this.opened={text:"",version:null};this.indexed=null;this.dragged=null;this.listeners=new Set}open(e,t,n=[],s=""){this.design={text:e,settings:new Map(n)},this.opened={text:e,version:t},this.saved=t===null?Mg:this.design,[this.past,this.future,this.selection,this.case]=[[],[],null,s],this.changed(!0)}get change(){let{text:e,settings:t}=this.design,n=t.size?Sg(t,this.index):[];return{text:e,version:e===this.opened.text?this.opened.version:null,settings:[...t,...n].map(([s,r])=>`${s} = ${r}`),case:this.case}}get index(){let{text:e}=this.design;return this.indexed?.text!==e&&(this.indexed={text:e,index:bg(e)}),this.indexed.index}get hasEdits(){return this.design.text!==this.opened.text||this.design.settings.size>0}get isSaved(){return this.design.text===this.saved.text&&this.design.settings.size===0}get history(){return{past:this.past,future:this.future}}get canUndo(){return this.past.length>0}get canRedo(){return this.future.length>0}set(e,t=!1){let n=this.design,s=new Map(n.settings);for(let[r,o]of Object.entries(e))s.set(r,o);t?this.dragged??=n:this.remember(this.dragged??n),t||(this.dragged=null),this.design={text:n.text,settings:s},this.changed(!1)}dropped(){this.dragged&&this.remember(this.dragged),this.dragged=null,this.notify()}edit(e){this.write(e,!1)}replaceNumber({from:e,to:t},n){let{text:s}=this.design;this.write(s.slice(0,e)+n+s.slice(t),!0)}folded(e){this.design={text:e,settings:new Map},this.changed(!1)}undo(){this.travel(this.past,this.future)}redo(){this.travel(this.future,this.past)}wasSaved(e,t,n=this.design){this.saved={text:e,settings:new Map},this.design===n&&(this.design=this.saved),this.opened={text:e,version:t},this.changed(!1)}replaced(e,t){this.remember(this.design),this.design=this.saved={text:e,settings:new Map},this.opened={text:e,version:t},da(this.index).includes(this.case)||(this.case=""),this.changed(!0)}wasDeleted(){this.opened={text:this.opened.text,version:null},this.saved=Mg,this.changed(!1)}put(e,t){this.remember(this.design,this.case),this.design=e,this.case=t,this.changed(!0)}resume(e,t,{past:n,future:s}){if(!n.length)return this.put(e,t);[this.past,this.future,this.design,this.case]=[[...n],[...s],e,t],this.changed(!0)}chooseCase(e){this.case=e,this.changed(!0)}select(e){this.selection=e,this.notify()}subscribe(e){return this.listeners.add(e),()=>this.listeners.delete(e)}write(e,t){e!==this.design.text&&(this.remember(this.design,null,t),this.design={text:e,settings:this.design.settings},this.changed(!t))}remember(e,t=null,n=!1){this.past.push({design:e,case:t,...n?{isNumber:n}:{}}),this.future=[]}travel(e,t){let n=e.pop();if(!n)return;let{isNumber:s=!1}=n;t.push({design:this.design,case:n.case===null?null:this.case,...s?{isNumber:s}:{}});let r=(s||n.design.text===this.design.text)&&(n.case??this.case)===this.case;this.design=n.design,this.case=n.case??this.case,this.changed(!r)}changed(e){this.revision++,e&&this.generation++,this.notify()}notify(){for(let e of this.listeners)e()}};var Eb="kept",Td="case ",Ad="three springs",rc="measured",wg=[[7,3],[2,3],[9,3,2,3],[4,2,1,2,1,2]];function Cd(i){if(!i.engine.isLive)return[];let{cases:e,state:t,index:n}=i,s=[...n.byPath.values()].some(r=>r.path[0]==="measurements");return[...e.filter(r=>r!==t.case).map(r=>Td+r),Ad,...s?[rc]:[]]}var Rd=i=>i===Td?"base model":i===Ad?"mounts as three springs":i,Pd=i=>Cd(i).filter(e=>i.display.compared.get(e)??e===rc),Eg=(i,e)=>Pd(i).includes(e);function Tg(i){let{change:e}=i.state,{quantity:t}=i.display,n=t?{quantity:t}:{};return Pd(i).map(s=>s===rc?{key:s,change:e,want:{command:"measurements"}}:s===Ad?{key:s,change:e,want:{command:"curves",keys:{...n,"three-springs":!0}}}:{key:s,change:{...e,case:s.slice(Td.length)},want:{command:"curves",keys:n}})}function Ag(i,e){let{beside:t}=i,n=i.asker.result("curves")?.models[0]?.excitations??[],s=Pd(i).map((r,o)=>{let a=r===rc?t.result(r)??[]:void 0,l=a?.map(c=>c.excitation).filter(c=>c!==null&&!(n.length===1&&n[0]===c))??[];return{key:r,label:Rd(r)+(l.length?` (${l.join(", ")} alone)`:""),curves:a?null:t.result(r),...a?{measured:a}:{},old:t.isOld(r),failure:t.failure(r),dash:wg[o%wg.length]}});return e?[...s,{key:Eb,label:"kept",curves:e,old:!1,failure:"",dash:[4,3]}]:s}var Cg={m:1,s:1,N:1,Hz:2*Math.PI,rpm:2*Math.PI/60,rad:1,deg:Math.PI/180,Pa:1,W:1,J:1,g:.001,t:1e3,"%":.01,kg:1,min:60,Nm:1,bar:1e5},Tb={k:1e3,M:1e6,G:1e9,c:.01,m:.001,µ:1e-6,u:1e-6,n:1e-9};function Rg(i){let e=1,t=1;for(let n of i.replaceAll("·"," ").split(/(\/)|\s+/).filter(Boolean)){if(n==="/"){t=-1;continue}let s=n.match(/^([^\d^]+)\^?(\d)?$/),r=s?.[1]??"",o=Number(s?.[2]??1),a=Cg[r]??(Tb[r[0]??""]??NaN)*(Cg[r.slice(1)]??NaN);if(!Number.isFinite(a))return null;e*=a**(t*o)}return e}function $s(i,e,t){let n=Rg(e),s=Rg(t);return e===t?i:n===null||s===null?null:i*n/s}function oc(i,e,t,n=""){let s=a=>Ed(a,n,e),r=Ab(i,e,s),o=t.map(a=>Lg(a,i,e,s)).filter(a=>a!==null);return r.length||o.length?[...r,...o]:Cb(i,e,s)}var fa=({paths:i,unit:e},t)=>Object.fromEntries(i.map(({path:n,factor:s})=>[n,mr(t*s,e)])),Pg=(i,e)=>Ig(e.byPath.get(["parameters",i,"path"].join("\0")),e),Id=i=>(i?.raw??"").replace(/^["']|["']$/g,"");function Ab(i,e,t){let n=new Set([...e.byPath.values()].filter(r=>r.path[0]==="parameters"&&r.path.length>1).map(r=>r.path[1])),s=[];for(let r of n){let o=p=>e.byPath.get(["parameters",r,p].join("\0")),a=kn(o("from")?.raw??""),l=kn(o("to")?.raw??""),c=Ig(o("path"),e).map(p=>({...p,path:t(p.path)}));if(!a||!l||!c.length)continue;let h=l.unit||a.unit,u=to(c[0].path,i,e),d=u?$s(u.value,u.unit,h):null,f=Math.min(Math.max(1,a.value),l.value);s.push({name:r,paths:c,unit:h,from:$s(a.value,a.unit,h)??a.value,to:l.value,logarithmic:Id(o("spacing"))==="logarithmic",value:(d??f)/c[0].factor})}return s}function Ig(i,e){return i?.kind==="array"?i.children.map(n=>({path:Id(n),factor:1})):i?.kind==="table"?i.children.map(n=>({path:n.path.slice(3).join("."),factor:kn(n.raw)?.value??1})):i?[{path:Id(i),factor:1}]:[...e.byPath.values()].filter(n=>n.path[0]==="parameters"&&n.path[2]==="path"&&n.kind==="number").map(n=>({path:n.path.slice(3).join("."),factor:kn(n.raw)?.value??1}))}function Lg(i,e,t,n){let s=n(i),r=t.numbers.get(s)?.raw,o=r?kn(r):{value:1,unit:""},a=to(s,e,t)??o;if(!o||!a)return null;let l=Math.abs(o.value),c=l>0?[o.value/2,o.value*2].sort((h,u)=>h-u):[-1,1];return{name:i,paths:[{path:s,factor:1}],from:c[0],to:c[1],logarithmic:o.value>0,unit:o.unit,value:$s(a.value,a.unit,o.unit)??o.value}}function Cb(i,e,t){let n=l=>[...new Set([...e.byPath.values()].filter(c=>c.path[0]===l&&c.path.length>1).map(c=>c.path[1]))],s=n("element_types").map(l=>["element_types",l]),r=n("elements").map(l=>["elements",l]),o=(s.length?s:r.slice(0,4)).map(l=>{let c=t(Ws([...l,"scale"]));return{name:`stiffness of ${l[1]}`,paths:[{path:c,factor:1}],from:.25,to:4,logarithmic:!0,unit:"",value:to(c,i,e)?.value??1}}),a=n("bodies").map(l=>({path:Ws(["bodies",l,"mass"]),name:l})).filter(({path:l})=>e.numbers.has(l)).map(({path:l,name:c})=>({...Lg(l,i,e,t),name:`mass of ${c}`}));return[...o,...a.slice(0,4)]}var pa=class{constructor(e,t,n,s){this.app=e;this.axis=t;this.map=n;this.which=s}get paths(){return this.slider?.paths.map(e=>e.path)??[this.axis.parameter]}get value(){let{state:e,index:t}=this.app,{axis:n}=this,s=this.paths.some(l=>e.design.settings.has(l)),r=this.map.marks.find(l=>l.case===e.case)?.[this.which]??null;if(!s&&e.case&&r!==null)return r;let{slider:o}=this;if(o)return $s(o.value,o.unit,n.unit);let a=to(n.parameter,e.design,t);return a?$s(a.value,a.unit,n.unit):r??(n.unit===""&&n.from<=1&&n.to>=1?1:null)}settings(e){let{slider:t,axis:n}=this,s=Number(e.toPrecision(4));return t?fa(t,$s(s,n.unit,t.unit)??s):{[n.parameter]:mr(s,n.unit)}}at(e){let{from:t,to:n,spacing:s}=this.axis;return s==="logarithmic"?t*(n/t)**e:t+e*(n-t)}get slider(){let{state:e,index:t}=this.app;return oc(e.design,t,[]).find(n=>n.name===this.axis.parameter)??null}},qs=({from:i,to:e,spacing:t},n)=>t==="logarithmic"?Math.log(n/i)/Math.log(e/i):(n-i)/(e-i);function Ld({from:i,to:e,spacing:t},n){if(t==="logarithmic"){let l=[1,2,5],c=Math.log10(e/i)*3>n?[1]:l,h=[];for(let u=Math.floor(Math.log10(i));u<=Math.log10(e);u++)for(let d of c)h.push(Number((d*10**u).toPrecision(3)));return h.filter(u=>u>=i*(1-1e-9)&&u<=e*(1+1e-9))}let s=(e-i)/n,r=10**Math.floor(Math.log10(s)),o=r*([1,2,5,10].find(l=>l*r>=s)??10),a=Math.ceil(i/o-1e-9);return Array.from({length:Math.floor(e/o+1e-9)-a+1},(l,c)=>Number(((a+c)*o).toPrecision(12)))}var no=(i,e)=>i[0]<e[2]&&i[2]>e[0]&&i[1]<e[3]&&i[3]>e[1];function Dd(i,e,t,n){let s=[];return i.map(r=>{let o=2*Dg(r,e.width).length,a=Rb(r,e.width,n).map((h,u)=>({number:u,box:h})).filter(({box:h})=>h[1]>=-15/2&&h[3]<=e.height&&!s.some(u=>no(h,u))),l=h=>i.some(u=>u!==r&&no(h,[u.left,u.top,u.right,u.top+1])),c=a.find(h=>h.number===r.before)??a.find(h=>h.number<o&&!l(h.box)&&!t(h.box))??a[0]??null;return c&&s.push(c.box),c})}function Rb(i,e,t){let n=Dg(i,e),s=[];for(let r=0;r<t;r++)for(let o of n)for(let a of[i.top-(r+1)*15,i.top+r*15+2])s.push([o-i.size,a,o,a+15]);return s}function Dg({left:i,right:e,size:t},n){if(e-i>=t)return Array.from({length:Math.floor((e-i+4)/(t+4))},(r,o)=>e-o*(t+4));let s=[e+4+t,i-4].filter(r=>r<=n&&r>=t);return s.length?s:[Math.max(e,Math.min(t,n))]}var Pb={light:["#0072B2","#D55E00","#009E73","#AA4499","#8A6D00","#3A3A3A"],dark:["#56B4E9","#F28E4B","#2FC7A0","#E39AC8","#F0E442","#D0D0D0"]},Ng=[[],[7,4],[2,3]],ts=(i,e)=>{let t=Pb[e];return{colour:t[i%t.length],dash:[...Ng[Math.floor(i/t.length)%Ng.length]]}},ns=i=>i==="dark"?{back:"#14191d",axis:"#9fb0bb",grid:"#2b343b",text:"#dbe5ec",limit:"#ffb347",violated:"#ff6b57",unbinding:"#b89a6a",mode:"#53616b"}:{back:"#ffffff",axis:"#50616c",grid:"#e3e8ec",text:"#24323b",limit:"#9a5b00",violated:"#c61a1a",unbinding:"#a98a5c",mode:"#b9c4cc"};var Ug=54,Ib=10,Og=8,Lb=34,ma=3.5,ac=(i,e)=>({left:Ug,top:Og,width:i-Ug-Ib,height:e-Og-Lb});function kg(i,e,t,n,s){let r=ac(t,n),o=ns(s),{x:a,y:l}=e,c=_=>r.left+qs(a,_)*r.width,h=_=>r.top+(1-qs(l,_))*r.height;i.clearRect(0,0,t,n),i.font="11px system-ui, sans-serif",i.save(),i.beginPath(),i.rect(r.left,r.top,r.width,r.height),i.clip(),i.imageSmoothingEnabled=!1;let[u,d]=[r.width/(a.points-1),r.height/(l.points-1)];i.drawImage(Ub(e),r.left-u/2,r.top-d/2,r.width+u,r.height+d);for(let _ of e.feasible.boundary)i.beginPath(),_.forEach(([m,g],y)=>y?i.lineTo(c(m),h(g)):i.moveTo(c(m),h(g))),i.strokeStyle=o.text,i.lineWidth=2,i.stroke();i.restore(),Fb(i,r,e,o.axis,o.text);let f=e.marks.flatMap(_=>_.of_this_model&&_.x!==null&&_.y!==null&&Fg(a,_.x)&&Fg(l,_.y)?[{mark:_,at:[c(_.x),h(_.y)]}]:[]);for(let{mark:_,at:m}of f)i.beginPath(),i.arc(...m,ma,0,7),i.fillStyle=_.kept===void 0?o.axis:_.kept?o.text:_.decides?o.violated:o.unbinding,i.fill(),i.strokeStyle=s==="dark"?"#000":"#fff",i.lineWidth=1,i.stroke();let p=f.map(({at:[_,m]})=>[_-ma,m-ma,_+ma,m+ma]);for(let{mark:_,at:m}of f)kb(i,_.case||"base model",m,r,p,s);e.best&&Bb(i,[c(e.best.x),h(e.best.y)],o.text,s)}var Fg=({from:i,to:e},t)=>t>=i&&t<=e,Db=255,Nb=71;function Ub({x:i,y:e,grid:t,colours:n}){let s=document.createElement("canvas");[s.width,s.height]=[i.points,e.points];let r=s.getContext("2d"),o=r.createImageData(i.points,e.points),a=new Map(n.map(({governing:l,colour:c})=>[l,Ob(c)]));return t.governing.forEach((l,c)=>{let h=e.points-1-Math.floor(c/i.points),u=4*(h*i.points+c%i.points),d=t.margin[c]??null,f=l==="none"||d!==null&&d>=1,[p,_,m]=a.get(l==="no model"?"not computed":l);o.data.set([p,_,m,f?Nb:Db],u)}),r.putImageData(o,0,0),s}var Ob=i=>[1,3,5].map(e=>parseInt(i.slice(e,e+2),16));function Fb(i,e,{x:t,y:n},s,r){let{left:o,top:a,width:l,height:c}=e;i.strokeStyle=s,i.lineWidth=1,i.strokeRect(o+.5,a+.5,l-1,c-1),i.fillStyle=r,i.textAlign="center";let h=-1/0;for(let d of Ld(t,l/55)){let f=o+qs(t,d)*l,p=je(d,4);i.fillRect(f,a+c,1,4),!(f-h<i.measureText(p).width+8)&&(h=f,i.fillText(p,Math.min(Math.max(f,o+6),o+l-6),a+c+15))}i.textAlign="right";let u=1/0;for(let d of Ld(n,c/28)){let f=a+(1-qs(n,d))*c;i.fillRect(o-4,f,4,1),!(u-f<13)&&(u=f,i.fillText(je(d,4),o-7,Math.min(f+4,a+c)))}i.textAlign="center",i.fillText(ga(t),o+l/2,a+c+29),i.save(),i.translate(11,a+c/2),i.rotate(-Math.PI/2),i.fillText(ga(n),0,0),i.restore()}var ga=({name:i,unit:e})=>e?`${i} [${e}]`:i;function kb(i,e,[t,n],s,r,o){let a=i.measureText(e).width,l=[t+6,t-6-a].filter(h=>h>=s.left&&h+a<=s.left+s.width),c=[n-5,n+14].flatMap(h=>l.map(u=>[u,h-10,u+a,h+2])).find(h=>h[1]>=s.top&&!r.some(u=>no(h,u)));c&&(r.push(c),i.textAlign="left",i.lineWidth=3,i.strokeStyle=ns(o).back,i.fillStyle=ns(o).text,i.strokeText(e,c[0],c[3]-2),i.fillText(e,c[0],c[3]-2))}function Bb(i,[e,t],n,s){i.beginPath();for(let r=0;r<10;r++){let o=r%2?3.2:8,a=Math.PI*(r/5-.5);i.lineTo(e+o*Math.cos(a),t+o*Math.sin(a))}i.closePath(),i.fillStyle=n,i.fill(),i.lineWidth=1,i.strokeStyle=s==="dark"?"#000":"#fff",i.stroke()}var Nd=class extends vn{constructor(){super();this.drawn=[];this.watcher=null;this.axes=t=>[new pa(this.app,t.x,t,"x"),new pa(this.app,t.y,t,"y")];[this.pair,this.spoken]=[0,""]}static{this.properties={...vn.properties,pair:{state:!0},spoken:{state:!0}}}connectedCallback(){super.connectedCallback(),this.unsubscribe.push(this.app.beside.subscribe(()=>this.requestUpdate()))}render(){let{beside:t}=this.app,n=this.maps,s=this.map,r=t.isRunning("map");if(!s)return ae`<p class="hint">${t.failure("map")||(t.takesLong("map")?this.app.engine.oneAtATime?"The kernel answers nothing else while it computes the map.":"The map takes longer than a second.":"Computing …")}</p>${this.computeButton()}`;let o=this.point(s),a=this.axes(s),l=`Map of ${ga(s.x)} and ${ga(s.y)}`;return ae`<div class="bar">${n.length>1?ae`<select aria-label="Pair of numbers" @change=${c=>{this.pair=Number(c.target.value)}}>
          ${n.map((c,h)=>ae`<option value=${h} ?selected=${h===this.pair}>${c.y.name} over ${c.x.name}</option>`)}</select>`:Ue}
        <span>${s.kept} of ${s.designs} designs meet all rules</span>${t.isOld("map")?ae`<span class="old" title="computed for other numbers">…</span>`:Ue}
        ${s.best?ae`<button title="Move the design to the largest margin of the map" @click=${()=>this.set(s,s.best.x,s.best.y)}>★ best</button>`:Ue}${r?Ue:this.computeButton()}</div>
      <div class="map" tabindex="0" role="application" aria-label="${l}. Arrow keys move the design, with Shift far." @keydown=${c=>this.key(c,s)}
           @pointerdown=${c=>this.pressed(c,s)} @pointermove=${c=>this.moved(c,s)} @pointerup=${()=>this.app.state.dropped()}>
        <canvas></canvas><span class="design" ?hidden=${!o} title="the design on the page"></span></div>
      <p class="hint">${o?this.words(s,o):`${a.map(c=>c.value===null?c.paths.join(", "):"").filter(Boolean).join(" and ")} is not in the file: click in the map to set it.`}</p>
      <ul class="rules">${s.colours.map(({colour:c,words:h})=>ae`<li><svg viewBox="0 0 12 12" aria-hidden="true"><rect width="12" height="12" fill=${c}></rect></svg>${h}</li>`)}
        <li class="note">colour: the rule with the least margin; light: all are met; ★ largest margin${s.marks.some(c=>c.kept===!1)?`; ●: cases, red if they violate a rule${s.marks.some(c=>!c.decides&&c.kept===!1)?", ochre where that is not binding":""}`:""}</li></ul>
      <p class="hidden" role="status" aria-live="polite">${this.spoken}</p>`}updated(){let{map:t}=this,n=this.querySelector(".map"),{theme:s}=this.app.display;if(!t||!n)return;this.watcher||(this.watcher=new ResizeObserver(()=>{this.drawn=[],this.requestUpdate()}),this.watcher.observe(n));let{clientWidth:r,clientHeight:o}=n,a=n.querySelector("canvas"),l=[t,r,o,s,devicePixelRatio];if(r<120||o<80)return;if(l.some((d,f)=>d!==this.drawn[f])){this.drawn=l,[a.width,a.height]=[r*devicePixelRatio,o*devicePixelRatio];let d=a.getContext("2d");d.scale(devicePixelRatio,devicePixelRatio),kg(d,t,r,o,s)}let c=this.point(t),h=n.querySelector(".design"),u=ac(r,o);c&&Object.assign(h.style,{left:`${u.left+c[0]*u.width}px`,top:`${u.top+(1-c[1])*u.height}px`})}disconnectedCallback(){super.disconnectedCallback(),this.watcher?.disconnect(),this.watcher=null}get maps(){let t=this.app.beside.result("map");return t?"pairs"in t?t.pairs:[t]:[]}get map(){return this.maps[this.pair]??this.maps[0]??null}computeButton(){let{beside:t}=this.app;return t.takesLong("map")?ae`<button @click=${()=>t.waitFor("map")}>Compute the map</button>`:Ue}point(t){let[n,s]=this.axes(t).map(o=>o.value),r=[n==null?NaN:qs(t.x,n),s==null?NaN:qs(t.y,s)];return r.every(o=>o>=-1e-9&&o<=1+1e-9)?r:null}words(t,[n,s]){let r=this.axes(t),[o,a]=[Math.round(n*(t.x.points-1)),Math.round(s*(t.y.points-1))],l=a*t.x.points+o,c=(f,p)=>`${t.x.name} ${`${je(f,4)} ${t.x.unit}`.trim()}, ${t.y.name} ${`${je(p,4)} ${t.y.unit}`.trim()}`,h=t.grid.margin[l],u=t.grid.governing[l],d=typeof u=="number"?`margin ${je(h,4)}, by ${t.colours.find(f=>f.governing===u).words}`:u==="none"?"nothing limits it":"no result";return`${c(r[0].value,r[1].value)}. Nearest design of the map, ${c(r[0].at(o/(t.x.points-1)),r[1].at(a/(t.y.points-1)))}: ${d}`}set(t,n,s,r=!1){let[o,a]=this.axes(t);this.app.state.set({...o.settings(n),...a.settings(s)},r)}to(t,n,s,r){let[o,a]=this.axes(t),l=c=>Math.min(Math.max(c,0),1);this.set(t,o.at(l(n)),a.at(l(s)),r)}pressed(t,n){if(t.button!==0)return;let s=t.currentTarget,[r,o]=Bg(t,s);r<-.02||r>1.02||o<-.02||o>1.02||(s.setPointerCapture(t.pointerId),s.focus(),this.to(n,r,o,!0),t.preventDefault())}moved(t,n){let s=t.currentTarget;s.hasPointerCapture(t.pointerId)&&this.to(n,...Bg(t,s),!0)}key(t,n){let s=t.shiftKey?.1:.01,[r,o]=this.point(n)??[.5,.5],a={ArrowLeft:[-s,0],ArrowRight:[s,0],ArrowUp:[0,s],ArrowDown:[0,-s]},l=a[t.key];if(!l||t.ctrlKey||t.metaKey||t.altKey)return;this.to(n,r+l[0],o+l[1],!1);let c=this.point(n);c&&(this.spoken=this.words(n,c)),t.preventDefault()}};function Bg(i,e){let{left:t,top:n}=e.getBoundingClientRect(),s=ac(e.clientWidth,e.clientHeight);return[(i.clientX-t-s.left)/s.width,1-(i.clientY-n-s.top)/s.height]}me.define("map-panel",Nd);function cc(i,e,t,n){let s=e?n.byPath.get(["cases",e,...i].join("\0")):void 0,r=s??n.byPath.get(i.join("\0"));if(!r)return null;let o=i.some((c,h)=>n.byPath.get(i.slice(0,h+1).join("\0"))?.kind==="array"),a=s||o?null:Ws(i),l=kn(a&&t.settings.get(a)||r.raw);return l&&{entry:r,path:a,...l}}var zg=i=>Number(i.toPrecision(3));function _a(i,{entry:e,path:t,unit:n},s,r=!1){if(t)return i.set({[t]:mr(s,n)},r);r||i.replaceNumber(e,mr(s,n))}var lc=class{constructor(){this.factors=new Map}allowed({place:e,allowed:t},{value:n,unit:s},r){let o=[...e,s].join("\0");r&&t!==null&&this.factors.set(o,t/n);let a=this.factors.get(o);return a===void 0?null:n*a}};var Vg={orders:"orders",random:"random excitations",time:"forces over time"};function hc(i){let{asker:e,index:t}=i,n=[...t.byPath.values()].filter(a=>a.path[0]==="excitations"&&a.path.length===3&&a.path[2]==="type").map(a=>a.raw.slice(1,-1)),s=Object.keys(Vg).filter(a=>n.includes(a)).map(a=>Vg[a]),r=e.missing("curves");return!r.includes("no harmonic excitation in the model")||!s.length?r:`Curves over frequency belong to a harmonic excitation; this machine has ${s.length>1?`${s.slice(0,-1).join(", ")} and ${s.at(-1)}`:s[0]}.${vi(i)?" What is required of it is judged in the table Requirements.":""}`}function uc(i,{display:e},t,n="a number"){e.set({notice:`"${i.value}" is not ${n}, perhaps with a unit; it stays ${t}.`}),i.value=t}var Gg={modes:"Modes",requirements:"Requirements",mounts:"Mounts",peaks:"Peaks",map:"Map"},zb=["x","y","z","θx","θy","θz"],Od=i=>i.engine.isLive&&i.index.byPath.has("analyses\0map");function kd(i){let{table:e}=i.display,t=vi(i)?"requirements":Od(i)?"map":"modes";return e&&(e!=="map"||Od(i))?e:t}var Fd=class extends vn{constructor(){super(...arguments);this.judged=t=>t.unit!=="rad/s"&&t.shown_value?t.shown_value:this.value(t.value,t.unit)}render(){let{app:t}=this,n=kd(t),s={modes:()=>this.modes(),requirements:()=>this.requirements(),mounts:()=>this.mounts(),peaks:()=>this.peaks(),map:()=>ae`<map-panel .app=${t}></map-panel>`},r=Object.keys(Gg).filter(o=>o!=="map"||Od(t));return ae`<div class="tabs" role="tablist" aria-label="Tables">${r.map(o=>ae`<button role="tab" id="tab-${o}" aria-controls="table-panel" aria-selected=${o===n} @click=${()=>this.choose(o)}>${Gg[o]}</button>`)}</div>
      <div class="scroll table" role="tabpanel" id="table-panel" aria-labelledby="tab-${n}" tabindex="0">${s[n]()}</div>`}choose(t){this.app.display.set({table:t}),this.app.beside.rest()}modes(){let{asker:t,display:n}=this.app,s=t.result("modes"),r=t.result("roots");if(!s)return this.missing("modes");let o=s.bodies.length===1,a=s.kinetic_energy_share_words??"shares of the kinetic energy";return ae`<table><thead><tr><th scope="col">Mode</th><th scope="col">${n.frequencyUnit}</th><th scope="col" title="damping ratio of the nearest root">ζ</th><th scope="col" class="words">motion</th>
      ${o?zb.map(l=>ae`<th scope="col" title=${a}>${l}</th>`):ae`<th scope="col">kinetic energy</th>`}</tr></thead><tbody>
      ${s.modes.map(l=>{let c=n.shown.kind==="mode"&&n.shown.number===l.number,h=r?.roots.find(u=>u.nearest_mode===l.number&&u.eigenvalue[1]>0);return ae`<tr aria-selected=${c} class=${c?"chosen":""} @click=${()=>n.set({shown:{kind:"mode",number:l.number}})}>
          <th scope="row"><button class="link" aria-label="Show mode ${l.number}">${l.number}</button></th><td>${es(l.angular_frequency,n.frequencyUnit).split(" ")[0]}</td>
          <td>${h?`${je(100*h.damping_ratio,3)} %`:r?"–":ae`<span class="old">…</span>`}</td><td class="words" title=${l.name}>${Gb(l.name)}</td>
          ${o?l.kinetic_energy_share.map(u=>ae`<td class=${Ud(u)?"share coupled":"share"} title=${Ud(u)?a:""}>${Math.abs(u)>=.005?Math.round(100*u):""}</td>`):ae`<td class="words">${Hb(s,l)}</td>`}</tr>`})}</tbody></table>${o?ae`<p class="hint">x … θz in %: ${s.modes.some(l=>l.kinetic_energy_share.some(Ud))?a:"shares of the kinetic energy"}.</p>`:Ue}${this.energies(s)}`}energies(t){let{shown:n}=this.app.display,s=n.kind==="mode"?t.modes.find(o=>o.number===n.number):void 0;if(!s)return Ue;let r=t.elements.map((o,a)=>({name:o,share:s.strain_energy_share?.[a]??0})).filter(o=>Math.abs(o.share)>=.005).sort((o,a)=>a.share-o.share);return ae`<p class="hint">Mode ${s.number}: ${s.name}. Strain energy: ${r.map(o=>`${o.name} ${je(100*o.share,3)} %`).join(", ")||"–"}.</p>`}requirements(){let{asker:t,state:n}=this.app,s=t.result("verdict");if(!vi(this.app))return ae`<p class="hint">The file has no [requirements], [limits] or limit lines. With them every design is judged here, with its margins.</p>`;if(!s)return this.missing("verdict");let r=s.cases.find(u=>u.case===n.case)??s.cases[0],o=[...r?.requirements??[]].sort((u,d)=>(u.margin??1/0)-(d.margin??1/0)),a=t.isOld("verdict")?ae` <span class="old">…</span>`:Ue,l=r?.decides!==!1,c=s.cases.length>1,h=o.some(u=>u.place.length);return ae`<table class="requirements">${l?Ue:ae`<caption>The requirements are not binding in this case.</caption>`}<thead><tr><th scope="col">Requirement</th><th scope="col" class="value">value${h?", limit":""}</th><th scope="col" class="margin" title="1: just met; more: met with room">margin</th>${c?ae`<th scope="col" class="elsewhere" title="least margin of all other cases">elsewhere</th>`:Ue}<th scope="col" class="met">met</th></tr></thead><tbody>
      ${o.map(u=>ae`<tr class=${u.judged?u.met?"":l?"violated":"unbinding":"unjudged"}><th scope="row" class="words">${u.shown_requirement??u.requirement}</th><td>${u.judged?this.judged(u):u.reason||"–"}${this.limit(u)}</td>
        <td>${u.margin===null?"–":je(u.margin,3)}${a}</td>${c?ae`<td>${this.elsewhere(s,u)}</td>`:Ue}<td>${u.judged?u.met?"✓":l?"✗":"(✗)":"–"}<span class="hidden">${u.met?"yes":l?"no":"no, not binding"}</span></td></tr>`)}</tbody></table>`}limit(t){let{state:n,index:s}=this.app,r=t.place.length?cc(t.place,n.case,n.design,s):null;if(!r)return"";let o=`${je(r.value,6)} ${r.unit}`.trim();return ae`<input class="number" aria-label="Limit: ${t.shown_requirement??t.requirement}" .value=${o} @change=${a=>{let l=a.target,c=kn(l.value.replaceAll("−","-").replace(",","."));c&&c.value>0?_a(n,{...r,unit:c.unit||r.unit},c.value):uc(l,this.app,o,"a number above 0")}}>`}elsewhere({cases:t},{kind:n,subject:s,requirement:r}){let o=t.filter(h=>h.case!==this.app.state.case).flatMap(h=>h.requirements.filter(u=>u.kind===n&&u.subject===s&&u.requirement===r&&u.judged&&u.margin!==null).map(u=>({in:h.case,binding:h.decides,r:u}))),a=o.filter(h=>h.binding&&!h.r.met),c=[...a.length?a:o].sort((h,u)=>h.r.margin-u.r.margin||Number(u.binding)-Number(h.binding))[0];return c?ae`<span class=${Hg(c.r,c.binding)}>${je(c.r.margin,3)} ${c.in||"base model"}${c.r.met||c.binding?"":", not binding"}</span>`:"–"}mounts(){let{asker:t,state:n}=this.app,s=t.result("check"),r=s?.mounts??[],o=r.filter(h=>h.case===n.case),a=o.length?o:r.filter(h=>h.case===""),l=t.result("verdict")?.cases.find(h=>h.case===n.case),c=(l?.requirements??[]).filter(h=>h.kind==="mount_load"&&h.judged);return s?a.length?ae`<table><caption>At rest under gravity</caption><thead><tr><th scope="col">Mount</th><th scope="col">compression</th><th scope="col">across</th><th scope="col">deflection</th>${c.length?ae`<th scope="col" title="of its load range in the catalogue; 1: just met">margin of load${l.decides?"":", not binding"}</th>`:Ue}</tr></thead><tbody>
      ${a.map(h=>{let u=n.selection?.kind==="element"&&n.selection.name===h.element;return ae`<tr class=${u?"chosen":""} @click=${()=>n.select({kind:"element",name:h.element})}><th scope="row"><button class="link">${h.element}</button></th>
          <td>${Qi(h.compression,"N")}</td><td>${Qi(h.across,"N")}</td><td>${Qi(h.deflection,"m")}</td>
          ${c.length?ae`<td>${c.filter(d=>d.subject===h.element).map(d=>ae`<span class=${Hg(d,l.decides)}>${d.margin===null?"–":je(d.margin,3)}</span>`)}</td>`:Ue}</tr>`})}</tbody></table>`:ae`<p class="hint">No load at rest: the file has no gravity, or no mount that carries a load.</p>`:this.missing("check")}peaks(){let{asker:t,display:n,engine:s}=this.app,r=t.result("curves");if(!r)return ae`<p class="hint">${hc(this.app)}</p>`;let o=new Map(r.results.map(c=>[c.name,c])),a=r.peaks.filter(c=>c.angular_frequency>=r.band[0]&&c.angular_frequency<=r.band[1]),l=({angular_frequency:c})=>{n.set({cursor:c,...s.isLive?{shown:{kind:"frequency",omega:c}}:{}}),t.again()};return ae`<table><thead><tr><th scope="col">Result</th><th scope="col">${n.frequencyUnit}</th><th scope="col">amplitude</th><th scope="col">phase</th></tr></thead><tbody>
      ${a.map(c=>ae`<tr @click=${()=>l(c)}>
        <th scope="row">${s.isLive?ae`<button class="link" aria-label="Show the motion at this peak of ${c.result}">${c.result}</button>`:c.result}</th><td>${es(c.angular_frequency,n.frequencyUnit).split(" ")[0]}</td>
        <td>${c.amplitude===null?"∞":Vb(c.amplitude,o.get(c.result))}</td><td>${c.phase==null?"–":`${je(Math.round(c.phase*18e6/Math.PI)/1e5,3)}°`}</td></tr>`)}</tbody></table>${t.notes("curves").map(c=>ae`<p class="hint">${c}</p>`)}`}value(t,n){return n==="rad/s"?es(t,this.app.display.frequencyUnit,3):n==="1"?je(t,3):Qi(t,n,3)}missing(t){return ae`<p class="hint">${this.app.asker.missing(t)}</p>`}},Ud=i=>i<=-.005||i>=1.005,Hg=({met:i},e)=>i?"":e?"bad":"minor";function Vb(i,e){let t=Wl(i,e?.unit??"",e);return`${je(i*t.factor)} ${t.unit}`.trim()}var Gb=i=>i.replace("mostly ","≈ ").replace("translation ","").replace("rotation ","").replace(/ through .*/,"").replace(/ \(.*?\)/," skew axis");function Hb(i,e){return i.bodies.map((n,s)=>({name:n,share:e.body_kinetic_energy_share[s]})).filter(n=>n.share>=.05).sort((n,s)=>s.share-n.share).slice(0,3).map(n=>`${n.name} ${Math.round(100*n.share)} %`).join(", ")}me.define("result-tables",Fd);function Wg(i,{hasSomethingToJudge:e,hasSteady:t,bodies:n}){let{shown:s}=i,r=[{want:{command:"scene"}},...Wb(i,n),...$b(i)];return s.kind==="frequency"&&r.push({want:{command:"shapes"},settings:[`analyses.shapes.at = ["${s.omega} rad/s"]`]}),r.push({want:{command:"roots"},slow:!i.damped},{want:{command:"check"},slow:!0}),e&&r.push({want:{command:"verdict"},slow:!0}),t&&r.push({want:{command:"steady",...s.kind==="steady"?{keys:{at:`${s.omega} rad/s`}}:{}},slow:!0}),r}function Wb({shown:i},e){let t={want:{command:"modes"}};return e<2?[t]:[{want:{command:"modes",keys:{"shapes-of":i.kind==="mode"?i.number:1}},as:pd("modes")},{...t,exact:!0}]}function $b({drawn:i,quantity:e}){let t=e?{quantity:e}:{},n={want:{command:"curves",keys:t}};return i.length?[{want:{command:"curves",keys:{...t,draft:!0,of:i}},as:"draft"},{...n,exact:!0}]:[n]}var qb=1e3;function $g(i){return i.state.design.text?[...Tg(i),...kd(i)==="map"?[Xb(i)]:[]]:[]}function Xb(i){let{change:e}=i.state,t=Yb(i),n=i.engine.oneAtATime?0:qb,s=e.settings.filter(r=>!t.has(r.slice(0,r.indexOf(" = "))));return{key:"map",change:{...e,settings:s},want:{command:"map"},patience:n}}function Yb({index:i}){let e=n=>i.byPath.get(n.join("\0"))?.raw.replace(/^["']|["']$/g,""),t=["x","y"].map(n=>e(["analyses","map",n,"parameter"])).filter(n=>n!==void 0);return new Set(t.flatMap(n=>nc(n).length>1?[n]:Pg(n,i).map(s=>s.path)))}function qg(i,e,t=i){let n=new sc,s=new Gl,r=()=>n.design.text?Wg(s,{hasSomethingToJudge:vi(c),hasSteady:c.index.byPath.has("analyses\0steady"),bodies:l.result("scene")?.bodies.length??0}):[],o=new Vl(t,()=>$g(c)),a={ask(...h){return i.oneAtATime||o.yield(),i.ask(...h)}},l=new Bl(a,n,r),c=new ic(i,e,n,s,l,o);return n.subscribe(o.rest),l.subscribe(o.rest),c}var Xg=i=>(...e)=>({_$litDirective$:i,values:e}),dc=class{constructor(e){}get _$AU(){return this._$AM._$AU}_$AT(e,t,n){this._$Ct=e,this._$AM=t,this._$Ci=n}_$AS(e,t){return this.update(e,t)}update(e,t){return this.render(...t)}};var{I:UL}=yg;var Zb={},Yg=(i,e=Zb)=>i._$AH=e;var Zg=Xg(class extends dc{constructor(){super(...arguments),this.key=Ue}render(i,e){return this.key=i,e}update(i,[e,t]){return e!==this.key&&(Yg(i),this.key=e),t}});var jb={rms:"the root mean square under the random excitations",largest:"the largest value over time",static:"the value at rest"};function Kg(i,e,t){let n=[],s=[];for(let r of t){let{kind:o,subject:a,unit:l,speed:c,band:h,place:u,order:d,excitations:f,level:p=null}=r,_=i.results.find(T=>T.name===a),m=jb[o];if(_&&m&&s.push({words:jg(r),why:`it limits ${m}`}),!u.length||o!=="amplitude"&&o!=="operation"&&o!=="steady")continue;let g=i.models[e]?.excitations??[],y=_?_.unit!==l?Jg(l,_.unit):o==="operation"&&p!==(_.level??null)?`it is judged ${p??"without a level"}, of all orders together, and the axis is ${_.level??"without a level"}`:d!==null?`it holds for order ${d} of the shaft alone`:o==="amplitude"&&f.length&&!Kb(f,g)?`it holds under ${f.join(", ")} alone`:"":`no curve of ${a} is drawn`;y?s.push({words:o==="operation"?jg(r):r.shown_requirement??r.requirement,why:y}):n.push({requirement:Jb(r,_.level_factor),result:a,from:(c??h)?.[0]??0,to:(c??h)?.[1]??1/0,isOfCurve:c===null&&o!=="steady"})}for(let r of i.lines??[]){let o=i.results.find(a=>a.name===r.result);o&&o.unit!==r.unit&&s.push({words:`${r.result} within "${r.name}"`,why:Jg(r.unit,o.unit)})}return{drawn:n,not:s}}function Qg({cases:i},{lines:e=[]}){let t=i.filter(n=>n.decides).flatMap(n=>n.requirements).find(n=>["amplitude","operation","steady","limit_line","rms","largest"].includes(n.kind));return t?.kind==="limit_line"?e.find(n=>n.result===t.subject)?.unit??null:t?.unit??null}function Jb(i,e=1){let t=n=>n===null?null:n/e;return i.kind==="operation"?{...i,allowed:t(i.allowed),value:t(i.value)}:i}var jg=i=>`${i.shown_requirement??i.requirement} (${i.judged?`${i.shown_value?`${i.shown_value}, `:""}margin ${je(i.margin??1/0,3)}`:"not judged"})`,Jg=(i,e)=>`it limits the ${Kr(i)}, the curve is the ${Kr(e)}`,Kb=(i,e)=>i.length===e.length&&i.every(t=>e.includes(t));var fc=class{constructor(e,t,n=[...Array(t).keys()]){this.model=e;this.wanted=n;this.out=new Float64Array(2*this.wanted.length);this.parts=e.pieces.map(s=>Qb(s,e.delays.length,t,n))}at(e){let{out:t}=this,n=this.parts.find(_=>e<=_.to)??this.parts.at(-1);if(t.fill(0),!n||this.model.undefined_at.includes(e))return t.fill(NaN);let{nodes:s,weights:r,products:o,inverse:a,values:l}=n,c=s.length,h=s.indexOf(e),u=0,d=0;if(h<0)for(let _=0;_<c;_++){let m=a[_]=1/(e-s[_]);u+=r[2*_]*m,d+=r[2*_+1]*m}else[u,d]=[1,0];let f=u*u+d*d,p=this.wanted.length;return this.model.delays.forEach((_,m)=>{let g=Math.cos(e*_),y=-Math.sin(e*_),T=(g*u+y*d)/f,b=(y*u-g*d)/f;for(let C=0;C<p;C++){let A=2*c*(m*p+C),x=0,M=0;if(h<0)for(let k=0,N=A;k<c;k++,N+=2)x+=o[N]*a[k],M+=o[N+1]*a[k];else[x,M]=[l[A+2*h],l[A+2*h+1]];t[2*C]+=T*x-b*M,t[2*C+1]+=T*M+b*x}}),t}};function e0(i,e){return Math.abs(e)<=1e-9*Math.abs(i)?i<0?Math.PI:0:Math.atan2(e,i)}function Qb({band:i,nodes:e,weights:t,values:n},s,r,o){let a=e.length,l=new Float64Array(2*a*s*o.length).fill(NaN),c=new Float64Array(l.length);for(let h=0;h<s;h++)o.forEach((u,d)=>l.set(n[h*r+u],2*a*(h*o.length+d)));for(let h=0;h<l.length;h+=2){let u=h%(2*a),[d,f,p,_]=[t[u],t[u+1],l[h],l[h+1]];c[h]=d*p-f*_,c[h+1]=d*_+f*p}return{to:i[1],nodes:Float64Array.from(e),weights:Float64Array.from(t),values:l,products:c,inverse:new Float64Array(a)}}var eS=Array.from({length:9},(i,e)=>10**(-4+.375*e)),tS=.001,nS=5;function Bd(i,e,t,n=i.results.map((s,r)=>r)){let[s,r]=i.band,o=s>0?s:r*.001,a=t?o:s,l=[a,r];for(let y=0;y<=e;y++){let T=y/e;l.push(t?o*(r/o)**T:a+(r-a)*T)}let c=new Set(n.map(y=>i.results[y].name)),h=i.peaks.filter(y=>c.has(y.result)).map(y=>y.angular_frequency);for(let y of n)for(let[T]of i.results[y].extrema??[])l.push(T);let u=[...i.natural,...h];l.push(...u);let d=0;for(let y of u.sort((T,b)=>T-b))if(!(y-d<tS*y)){d=y;for(let T of eS)l.push(y*(1-T),y*(1+T))}let f=[...new Set(l)].filter(y=>y>=a&&y<=r).sort((y,T)=>y-T);if(!i.draft)return f;let p=new Set(u),_=1/(nS*e),m=(y,T)=>(t?Math.log(T/y)/Math.log(r/o):(T-y)/(r-a))>_,g=-1/0;return f.filter(y=>{let T=p.has(y)||y===r||g<o||m(g,y);return T&&(g=y),T})}function zd(i,e,t,n=i.results.map((s,r)=>r)){let{results:s}=i,r=i.models[e],o=s.map(()=>[]),a=s.map(()=>[]);if(!r)return{omega:[],amplitude:o,phase:a};let l=n.map(h=>new Map([...s[h].extrema??[],...i.peaks.filter(u=>u.result===s[h].name).map(u=>[u.angular_frequency,u.amplitude])])),c=new fc(r,s.length,n);for(let h of t){let u=c.at(h);for(let d=0;d<n.length;d++){let f=n[d],p=u[2*d],_=u[2*d+1],m=Math.sqrt(p*p+_*_),g=Number.isFinite(m);o[f].push(g?l[d].get(h)??m:null),a[f].push(g&&m>0?e0(p,_)*180/Math.PI:null)}}return{omega:t,amplitude:o,phase:a}}function t0(i,e,t,n,s,r){return i.flatMap(({channels:o})=>o.flatMap(a=>{let l=n.indexOf(a.result);return l<0||a.unit!==t?[]:[{name:a.result,stroke:l,kind:"measured",of:e,points:a.angular_frequency.map((c,h)=>[c*s,r(Math.hypot(...a.measured[h]))])}]}))}function n0({kind:i,points:e},t){let n=e.findIndex(l=>l[0]>=t),s=e[n],r=e[n-1]??s;if(!r||!s||n===0&&s[0]>t)return null;let o=s[0]>r[0]?(t-r[0])/(s[0]-r[0]):0;if(i==="measured"){let[l,c]=o<.5?r:s;return c===null?null:{x:l,y:c}}let a=o===0?r[1]:o===1?s[1]:r[1]===null||s[1]===null?null:r[1]+o*(s[1]-r[1]);return a===null?null:{x:t,y:a}}function i0(i,e,t,n,s){if(i.over!=="frequency")return[];let r=[];return i.results.forEach(({name:o,unit:a},l)=>{let c=t.indexOf(o);if(c<0||a!==e)return;let h=u=>[u.angular_frequency*n,s((u.results[l].largest-u.results[l].smallest)/2)];for(let u of[i,...i.further??[]]){r.push(...iS(u.points,h).map(({stable:d,points:f})=>({name:o,stroke:c,kind:d?"stable":"unstable",points:f})));for(let{point:d,lands:f}of u.folds)f&&r.push({name:o,stroke:c,kind:"jump",points:[h(d),h(f)]})}}),r}function s0(i){let e=new Map;for(let{kind:t,name:n,stroke:s,points:r}of i)if(t==="stable")for(let[o,a]of r)a!==null&&a>(e.get(n)?.y??-1/0)&&e.set(n,{x:o,y:a,stroke:s});return[...e.values()]}function iS(i,e){let t=[];return i.forEach((n,s)=>{let r=t.at(-1);r?.stable===n.stable?r.points.push(e(n)):t.push({stable:n.stable,points:s>0?[e(i[s-1]),e(n)]:[e(n)]})}),t}var r0=420,pc=({results:i,vanishing:e=[]})=>[...new Set(i.filter(t=>!e.includes(t.name)).map(t=>t.unit))];function o0(i,e,t,n=null,s=[],r=!0){let o=Li[t.frequencyUnit],a=i.results.map((y,T)=>T).filter(y=>i.results[y].unit===e.unit&&!i.vanishing?.includes(i.results[y].name)),l=a.filter(y=>!e.hidden.has(i.results[y].name)),c=Bd(i,r0,t.logarithmicFrequency,l),h=zd(i,e.model,c,l),u=l.reduce((y,T)=>h.amplitude[T].reduce((b,C)=>Math.max(b,C??0),y),0),d=i.results[a[0]??-1],f=t.decibel?{factor:d?.level_factor??1,unit:`${e.unit} ${d?.level??""}`.trim()}:Wl(u,e.unit,d),p=a.map(y=>i.results[y].name),_=y=>Vd(y,f,t),m=l.map(y=>{let{name:T}=i.results[y];return{name:T,stroke:a.indexOf(y),amplitude:h.amplitude[y].map(_),phase:h.phase[y],peaks:i.peaks.filter(b=>b.result===T&&b.amplitude!==null&&b.amplitude>1e-4*u).map(b=>({x:b.angular_frequency*o,y:_(b.amplitude)}))}}),g=n?i0(n,e.unit,p,o,_).filter(y=>!e.hidden.has(y.name)):[];for(let y of i.lines??[]){let T=p.indexOf(y.result),b=Jm(y.rms?"rms":"0-p");if(T<0||y.unit!==e.unit||e.hidden.has(y.result))continue;g.push({name:y.result,stroke:T,kind:"limit",points:y.angular_frequency.map((A,x)=>[A*o,_(y.limit[x]/b)])});let C=h.amplitude[i.results.findIndex(A=>A.name===y.result)]??[];for(let[A,x]of y.exceeded??[])g.push({name:y.result,stroke:T,kind:r?"violated":"unbinding",points:c.flatMap((M,k)=>M>=A&&M<=x?[[M*o,_(C[k]??null)]]:[])})}for(let y of s)y.curves&&g.push(...oS(y.curves,y,e,t,p,_)),y.measured&&g.push(...t0(y.measured,y.key,e.unit,p,o,_).filter(T=>!e.hidden.has(T.name)));return{overlays:g,limits:[],x:c.map(y=>y*o),curves:m,natural:i.natural.map(y=>y*o),scale:f,cursor:t.cursor===null?null:t.cursor*o}}function Vd(i,{factor:e},{decibel:t,logarithmicAmplitude:n}){return i===null||!(i>0||!t&&!n)?null:t?20*Math.log10(i*e):i*e}var a0=(i,{factor:e},{decibel:t})=>(t?10**(i/20):i)/e;function l0(i,e,t,n,s){let r=Li[s.frequencyUnit];return i.flatMap(({limit:{requirement:o,result:a,from:l,to:c,isOfCurve:h},allowed:u,written:d,movable:f,old:p,binding:_},m)=>{let g=e.indexOf(a),y=Vd(u,n,s);if(g<0||t.has(a)||y===null)return[];let T=!h&&o.value!==null?Vd(o.value,n,s):null,b=o.judged&&!o.met,C=o.kind==="steady",A=o.judged?o.margin===null?"nothing limits it":`margin ${je(o.margin,3)}${b&&!_?", not binding":""}`:"not judged",x=M=>`${C?"steady ":""}≤ ${M} · ${A}${p?" …":""}`;return[{id:`${m} ${o.place.join(".")}`,result:a,from:l*r,to:c*r,y,label:x(sS(d,y,n,s)),short:x(rS(d,o.level??"",y,n,s)),violated:b,binding:_,movable:f,...ts(g,s.theme),words:`${o.shown_requirement??o.requirement}: ${A}${b?", violated":""}${C?"; square: the largest deviation of the steady motions from rest":""}`,isOfCurve:h,at:T!==null?{x:(C?o.angular_frequency??l:(l+c)/2)*r,y:T}:null}]})}function sS(i,e,{unit:t},{decibel:n}){let s=`${je(e)} ${t}`;return n||i===s?i:s.startsWith(`${i} `)?s:`${i} = ${s}`}function rS(i,e,t,{unit:n},{decibel:s}){let r=kn(i);if(s)return i;if(!r?.unit)return je(t);let o=/(0-p|rms|p-p)$/.test(r.unit)||!e?r.unit:`${r.unit} ${e}`;return je(r.value)+(o===n?"":` ${o}`)}function oS(i,{key:e,dash:t},n,s,r,o){let a=Bd(i,r0,s.logarithmicFrequency),l=i.results.map((h,u)=>u).filter(h=>i.results[h].unit===n.unit&&r.includes(i.results[h].name)&&!n.hidden.has(i.results[h].name)),c=zd(i,n.model,a,l);return l.map(h=>{let{name:u}=i.results[h];return{name:u,stroke:r.indexOf(u),kind:"compared",of:e,dash:t,points:a.map((d,f)=>[d*Li[s.frequencyUnit],o(c.amplitude[h][f])])}})}var aS="uplot",lS="u-hz",cS="u-vt",hS="u-title",uS="u-wrap",dS="u-under",fS="u-over",pS="u-axis",wr="u-off",mS="u-select",gS="u-cursor-x",_S="u-cursor-y",yS="u-cursor-pt",xS="u-legend",vS="u-live",bS="u-inline",SS="u-series",MS="u-marker",c0="u-label",wS="u-value",xa="width",va="height";var h0="bottom",io="left",Gd="right",of="#000",u0=of+"0",Hd="mousemove",d0="mousedown",Wd="mouseup",f0="mouseenter",p0="mouseleave",m0="dblclick",ES="resize",TS="scroll",g0="change",xc="dppxchange",af="--",ho=typeof window<"u",Zd=ho?document:null,ro=ho?window:null,AS=ho?navigator:null,Rt,mc;function jd(){let i=devicePixelRatio;Rt!=i&&(Rt=i,mc&&Kd(g0,mc,jd),mc=matchMedia(`(min-resolution: ${Rt-.001}dppx) and (max-resolution: ${Rt+.001}dppx)`),Er(g0,mc,jd),ro.dispatchEvent(new CustomEvent(xc)))}function ai(i,e){if(e!=null){let t=i.classList;!t.contains(e)&&t.add(e)}}function Jd(i,e){let t=i.classList;t.contains(e)&&t.remove(e)}function Yt(i,e,t){i.style[e]=t+"px"}function Di(i,e,t,n){let s=Zd.createElement(i);return e!=null&&ai(s,e),t?.insertBefore(s,n),s}function bi(i,e){return Di("div",i,e)}var _0=new WeakMap;function is(i,e,t,n,s){let r="translate("+e+"px,"+t+"px)",o=_0.get(i);r!=o&&(i.style.transform=r,_0.set(i,r),e<0||t<0||e>n||t>s?ai(i,wr):Jd(i,wr))}var y0=new WeakMap;function x0(i,e,t){let n=e+t,s=y0.get(i);n!=s&&(y0.set(i,n),i.style.background=e,i.style.borderColor=t)}var v0=new WeakMap;function b0(i,e,t,n){let s=e+""+t,r=v0.get(i);s!=r&&(v0.set(i,s),i.style.height=t+"px",i.style.width=e+"px",i.style.marginLeft=n?-e/2+"px":0,i.style.marginTop=n?-t/2+"px":0)}var lf={passive:!0},CS={...lf,capture:!0};function Er(i,e,t,n){e.addEventListener(i,t,n?CS:lf)}function Kd(i,e,t,n){e.removeEventListener(i,t,lf)}ho&&jd();function Ni(i,e,t,n){let s;t=t||0,n=n||e.length-1;let r=n<=2147483647;for(;n-t>1;)s=r?t+n>>1:li((t+n)/2),e[s]<i?t=s:n=s;return i-e[t]<=e[n]-i?t:n}function Z0(i){return(t,n,s)=>{let r=-1,o=-1;for(let a=n;a<=s;a++)if(i(t[a])){r=a;break}for(let a=s;a>=n;a--)if(i(t[a])){o=a;break}return[r,o]}}var j0=i=>i!=null,J0=i=>i!=null&&i>0,Sc=Z0(j0),RS=Z0(J0);function PS(i,e,t,n=0,s=!1){let r=s?RS:Sc,o=s?J0:j0;[e,t]=r(i,e,t);let a=i[e],l=i[e];if(e>-1)if(n==1)a=i[e],l=i[t];else if(n==-1)a=i[t],l=i[e];else for(let c=e;c<=t;c++){let h=i[c];o(h)&&(h<a?a=h:h>l&&(l=h))}return[a??Vt,l??-Vt]}function Mc(i,e,t,n){let s=w0(i),r=w0(e);i==e&&(s==-1?(i*=t,e/=t):(i/=t,e*=t));let o=t==10?xs:K0,a=s==1?li:Si,l=r==1?Si:li,c=a(o(Sn(i))),h=l(o(Sn(e))),u=oo(t,c),d=oo(t,h);return t==10&&(c<0&&(u=Gt(u,-c)),h<0&&(d=Gt(d,-h))),n||t==2?(i=u*s,e=d*r):(i=n_(i,u),e=wc(e,d)),[i,e]}function cf(i,e,t,n){let s=Mc(i,e,t,n);return i==0&&(s[0]=0),e==0&&(s[1]=0),s}var hf=.1,S0={mode:3,pad:hf},Sa={pad:0,soft:null,mode:0},IS={min:Sa,max:Sa};function vc(i,e,t,n){return Ec(t)?M0(i,e,t):(Sa.pad=t,Sa.soft=n?0:null,Sa.mode=n?3:0,M0(i,e,IS))}function At(i,e){return i??e}function LS(i,e,t){for(e=At(e,0),t=At(t,i.length-1);e<=t;){if(i[e]!=null)return!0;e++}return!1}function M0(i,e,t){let n=t.min,s=t.max,r=At(n.pad,0),o=At(s.pad,0),a=At(n.hard,-Vt),l=At(s.hard,Vt),c=At(n.soft,Vt),h=At(s.soft,-Vt),u=At(n.mode,0),d=At(s.mode,0),f=e-i,p=xs(f),_=Xn(Sn(i),Sn(e)),m=xs(_),g=Sn(m-p);(f<1e-24||g>10)&&(f=0,(i==0||e==0)&&(f=1e-24,u==2&&c!=Vt&&(r=0),d==2&&h!=-Vt&&(o=0)));let y=f||_||1e3,T=xs(y),b=oo(10,li(T)),C=y*(f==0?i==0?.1:1:r),A=Gt(n_(i-C,b/10),24),x=i>=c&&(u==1||u==3&&A<=c||u==2&&A>=c)?c:Vt,M=Xn(a,A<x&&i>=x?x:Ui(x,A)),k=y*(f==0?e==0?.1:1:o),N=Gt(wc(e+k,b/10),24),D=e<=h&&(d==1||d==3&&N>=h||d==2&&N<=h)?h:-Vt,V=Ui(l,N>D&&e<=D?D:Xn(D,N));return M==V&&M==0&&(V=100),[M,V]}var DS=new Intl.NumberFormat(ho?AS.language:"en-US"),uf=i=>DS.format(i),ci=Math,yc=ci.PI,Sn=ci.abs,li=ci.floor,bn=ci.round,Si=ci.ceil,Ui=ci.min,Xn=ci.max,oo=ci.pow,w0=ci.sign,xs=ci.log10,K0=ci.log2,NS=(i,e=1)=>ci.sinh(i)*e,$d=(i,e=1)=>ci.asinh(i/e),Vt=1/0;function E0(i){return(xs((i^i>>31)-(i>>31))|0)+1}function Qd(i,e,t){return Ui(Xn(i,e),t)}function Q0(i){return typeof i=="function"}function vt(i){return Q0(i)?i:()=>i}var US=()=>{},e_=i=>i,t_=(i,e)=>e,OS=i=>null,T0=i=>!0,A0=(i,e)=>i==e,FS=/\.\d*?(?=9{6,}|0{6,})/gm,Tr=i=>{if(s_(i)||Ys.has(i))return i;let e=`${i}`,t=e.match(FS);if(t==null)return i;let n=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${Tr(s)}e${r}`}return Gt(i,n)};function Sr(i,e){return Tr(Gt(Tr(i/e))*e)}function wc(i,e){return Tr(Si(Tr(i/e))*e)}function n_(i,e){return Tr(li(Tr(i/e))*e)}function Gt(i,e=0){if(s_(i))return i;let t=10**e,n=i*t*(1+Number.EPSILON);return bn(n)/t}var Ys=new Map;function i_(i){return((""+i).split(".")[1]||"").length}function wa(i,e,t,n){let s=[],r=n.map(i_);for(let o=e;o<t;o++){let a=Sn(o),l=Gt(oo(i,o),a);for(let c=0;c<n.length;c++){let h=i==10?+`${n[c]}e${o}`:n[c]*l,u=(o>=0?0:a)+(o>=r[c]?0:r[c]),d=i==10?h:Gt(h,u);s.push(d),Ys.set(d,u)}}return s}var Ma={},df=[],ao=[null,null],Xs=Array.isArray,s_=Number.isInteger,kS=i=>i===void 0;function C0(i){return typeof i=="string"}function Ec(i){let e=!1;if(i!=null){let t=i.constructor;e=t==null||t==Object}return e}function BS(i){return i!=null&&typeof i=="object"}var zS=Object.getPrototypeOf(Uint8Array),r_="__proto__";function lo(i,e=Ec){let t;if(Xs(i)){let n=i.find(s=>s!=null);if(Xs(n)||e(n)){t=Array(i.length);for(let s=0;s<i.length;s++)t[s]=lo(i[s],e)}else t=i.slice()}else if(i instanceof zS)t=i.slice();else if(e(i)){t={};for(let n in i)n!=r_&&(t[n]=lo(i[n],e))}else t=i;return t}function mn(i){let e=arguments;for(let t=1;t<e.length;t++){let n=e[t];for(let s in n)s!=r_&&(Ec(i[s])?mn(i[s],lo(n[s])):i[s]=lo(n[s]))}return i}var VS=0,GS=1,HS=2;function WS(i,e,t){for(let n=0,s,r=-1;n<e.length;n++){let o=e[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<t&&i[s]==null;)i[r=s++]=null}}}function $S(i,e){if(YS(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return ZS(o[0])||(o=XS(o)),o}let t=new Set;for(let o=0;o<i.length;o++){let l=i[o][0],c=l.length;for(let h=0;h<c;h++)t.add(l[h])}let n=[Array.from(t).sort((o,a)=>o-a)],s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],l=a[0];for(let c=1;c<a.length;c++){let h=a[c],u=Array(s).fill(void 0),d=e?e[o][c]:GS,f=[];for(let p=0;p<h.length;p++){let _=h[p],m=r.get(l[p]);_===null?d!=VS&&(u[m]=_,d==HS&&f.push(m)):u[m]=_}WS(u,f,s),n.push(u)}}return n}var qS=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function XS(i){let e=i[0],t=e.length,n=Array(t);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<i.length;r++){let o=i[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[n[l]];s.push(a)}return s}function YS(i){let e=i[0][0],t=e.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function ZS(i,e=100){let t=i.length;if(t<=1)return!0;let n=0,s=t-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=Xn(1,li((s-n+1)/e));for(let o=i[n],a=n+r;a<=s;a+=r){let l=i[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var o_=["January","February","March","April","May","June","July","August","September","October","November","December"],a_=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function l_(i){return i.slice(0,3)}var jS=a_.map(l_),JS=o_.map(l_),KS={MMMM:o_,MMM:JS,WWWW:a_,WWW:jS};function ya(i){return(i<10?"0":"")+i}function QS(i){return(i<10?"00":i<100?"0":"")+i}var eM={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,e)=>e.MMMM[i.getMonth()],MMM:(i,e)=>e.MMM[i.getMonth()],MM:i=>ya(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>ya(i.getDate()),D:i=>i.getDate(),WWWW:(i,e)=>e.WWWW[i.getDay()],WWW:(i,e)=>e.WWW[i.getDay()],HH:i=>ya(i.getHours()),H:i=>i.getHours(),h:i=>{let e=i.getHours();return e==0?12:e>12?e-12:e},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>ya(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>ya(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>QS(i.getMilliseconds())};function ff(i,e){e=e||KS;let t=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)t.push(s[0][0]=="{"?eM[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var tM=new Intl.DateTimeFormat().resolvedOptions().timeZone;function nM(i,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+i+i.getTimezoneOffset()*6e4):e==tM?t=i:(t=new Date(i.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(i.getMilliseconds())),t}var c_=i=>i%1==0,bc=[1,2,2.5,5],iM=wa(10,-32,0,bc),h_=wa(10,0,32,bc),sM=h_.filter(c_),Mr=iM.concat(h_),pf=`
`,u_="{YYYY}",R0=pf+u_,d_="{M}/{D}",ba=pf+d_,gc=ba+"/{YY}",f_="{aa}",rM="{h}:{mm}",so=rM+f_,P0=pf+so,I0=":{ss}",Lt=null;function p_(i){let e=i*1e3,t=e*60,n=t*60,s=n*24,r=s*30,o=s*365,l=(i==1?wa(10,0,3,bc).filter(c_):wa(10,-3,0,bc)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,u_,Lt,Lt,Lt,Lt,Lt,Lt,1],[s*28,"{MMM}",R0,Lt,Lt,Lt,Lt,Lt,1],[s,d_,R0,Lt,Lt,Lt,Lt,Lt,1],[n,"{h}"+f_,gc,Lt,ba,Lt,Lt,Lt,1],[t,so,gc,Lt,ba,Lt,Lt,Lt,1],[e,I0,gc+" "+so,Lt,ba+" "+so,Lt,P0,Lt,1],[i,I0+".{fff}",gc+" "+so,Lt,ba+" "+so,Lt,P0,Lt,1]];function h(u){return(d,f,p,_,m,g)=>{let y=[],T=m>=o,b=m>=r&&m<o,C=u(p),A=Gt(C*i,3),x=qd(C.getFullYear(),T?0:C.getMonth(),b||T?1:C.getDate()),M=Gt(x*i,3);if(b||T){let k=b?m/r:0,N=T?m/o:0,D=A==M?A:Gt(qd(x.getFullYear()+N,x.getMonth()+k,1)*i,3),V=new Date(bn(D/i)),W=V.getFullYear(),U=V.getMonth();for(let G=0;D<=_;G++){let Z=qd(W+N*G,U+k*G,1),z=Z-u(Gt(Z*i,3));D=Gt((+Z+z)*i,3),D<=_&&y.push(D)}}else{let k=m>=s?s:m,N=li(p)-li(A),D=M+N+wc(A-M,k);y.push(D);let V=u(D),W=V.getHours()+V.getMinutes()/t+V.getSeconds()/n,U=m/n,G=d.axes[f]._space,Z=g/G;for(;D=Gt(D+m,i==1?0:3),!(D>_);)if(U>1){let z=li(Gt(W+U,6))%24,K=u(D).getHours()-z;K>1&&(K=-1),D-=K*n,W=(W+U)%24;let ie=y[y.length-1];Gt((D-ie)/m,3)*Z>=.7&&y.push(D)}else y.push(D)}return y}}return[l,c,h]}var[oM,aM,lM]=p_(1),[cM,hM,uM]=p_(.001);wa(2,-53,53,[1]);function L0(i,e){return i.map(t=>t.map((n,s)=>s==0||s==8||n==null?n:e(s==1||t[8]==0?n:t[1]+n)))}function D0(i,e){return(t,n,s,r,o)=>{let a=e.find(p=>o>=p[0])||e[e.length-1],l,c,h,u,d,f;return n.map(p=>{let _=i(p),m=_.getFullYear(),g=_.getMonth(),y=_.getDate(),T=_.getHours(),b=_.getMinutes(),C=_.getSeconds(),A=m!=l&&a[2]||g!=c&&a[3]||y!=h&&a[4]||T!=u&&a[5]||b!=d&&a[6]||C!=f&&a[7]||a[1];return l=m,c=g,h=y,u=T,d=b,f=C,A(_)})}}function dM(i,e){let t=ff(e);return(n,s,r,o,a)=>s.map(l=>t(i(l)))}function qd(i,e,t){return new Date(i,e,t)}function N0(i,e){return e(i)}var fM="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function U0(i,e){return(t,n,s,r)=>r==null?af:e(i(n))}function pM(i,e){let t=i.series[e];return t.width?t.stroke(i,e):t.points.width?t.points.stroke(i,e):null}function mM(i,e){return i.series[e].fill(i,e)}var gM={show:!0,live:!0,isolate:!1,mount:US,markers:{show:!0,width:2,stroke:pM,fill:mM,dash:"solid"},idx:null,idxs:null,values:[]};function _M(i,e){let t=i.cursor.points,n=bi(),s=t.size(i,e);Yt(n,xa,s),Yt(n,va,s);let r=s/-2;Yt(n,"marginLeft",r),Yt(n,"marginTop",r);let o=t.width(i,e,s);return o&&Yt(n,"borderWidth",o),n}function yM(i,e){let t=i.series[e].points;return t._fill||t._stroke}function xM(i,e){let t=i.series[e].points;return t._stroke||t._fill}function vM(i,e){return i.series[e].points.size}var Xd=[0,0];function bM(i,e,t){return Xd[0]=e,Xd[1]=t,Xd}function _c(i,e,t,n=!0){return s=>{s.button==0&&(!n||s.target==e)&&t(s)}}function Yd(i,e,t,n=!0){return s=>{(!n||s.target==e)&&t(s)}}var SM={show:!0,x:!0,y:!0,lock:!1,move:bM,points:{one:!1,show:_M,size:vM,width:0,stroke:xM,fill:yM},bind:{mousedown:_c,mouseup:_c,click:_c,dblclick:_c,mousemove:Yd,mouseleave:Yd,mouseenter:Yd},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,e,t,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},m_={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},mf=mn({},m_,{filter:t_}),g_=mn({},mf,{size:10}),__=mn({},m_,{show:!1}),gf='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',y_="bold "+gf,x_=1.5,O0={show:!0,scale:"x",stroke:of,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:y_,side:2,grid:mf,ticks:g_,border:__,font:gf,lineGap:x_,rotate:0},MM="Value",wM="Time",F0={show:!0,scale:"x",auto:!1,sorted:1,min:Vt,max:-Vt,idxs:[]};function EM(i,e,t,n,s){return e.map(r=>r==null?"":uf(r))}function TM(i,e,t,n,s,r,o){let a=[],l=Ys.get(s)||0;t=o?t:Gt(wc(t,s),l);for(let c=t;c<=n;c=Gt(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function ef(i,e,t,n,s,r,o){let a=[],l=i.scales[i.axes[e].scale].log,c=l==10?xs:K0,h=li(c(t));s=oo(l,h),l==10&&(s=Mr[Ni(s,Mr)]);let u=t,d=s*l;l==10&&(d=Mr[Ni(d,Mr)]);do a.push(u),u=u+s,l==10&&!Ys.has(u)&&(u=Gt(u,Ys.get(s))),u>=d&&(s=u,d=s*l,l==10&&(d=Mr[Ni(d,Mr)]));while(u<=n);return a}function AM(i,e,t,n,s,r,o){let l=i.scales[i.axes[e].scale].asinh,c=n>l?ef(i,e,Xn(l,t),n,s):[l],h=n>=0&&t<=0?[0]:[];return(t<-l?ef(i,e,Xn(l,-n),-t,s):[l]).reverse().map(d=>-d).concat(h,c)}var v_=/./,CM=/[12357]/,RM=/[125]/,k0=/1/,tf=(i,e,t,n)=>i.map((s,r)=>e==4&&s==0||r%n==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function PM(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=i.scales[o],l=i.valToPos,c=r._space,h=l(10,o),u=l(9,o)-h>=c?v_:l(7,o)-h>=c?CM:l(5,o)-h>=c?RM:k0;if(u==k0){let d=Sn(l(1,o)-h);if(d<c)return tf(e.slice().reverse(),a.distr,u,Si(c/d)).reverse()}return tf(e,a.distr,u,1)}function IM(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=r._space,l=i.valToPos,c=Sn(l(1,o)-l(2,o));return c<a?tf(e.slice().reverse(),3,v_,Si(a/c)).reverse():e}function LM(i,e,t,n){return n==null?af:e==null?"":uf(e)}var B0={show:!0,scale:"y",stroke:of,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:y_,side:3,grid:mf,ticks:g_,border:__,font:gf,lineGap:x_,rotate:0};function DM(i,e){let t=3+(i||1)*2;return Gt(t*e,3)}function NM(i,e){let{scale:t,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],t,!0),o=i.valToPos(s[n[1]],t,!0),a=Sn(o-r),l=i.series[e],c=a/(l.points.space*Rt);return n[1]-n[0]<=c}var z0={scale:null,auto:!0,sorted:0,min:Vt,max:-Vt},b_=(i,e,t,n,s)=>s,V0={show:!0,auto:!0,sorted:0,gaps:b_,alpha:1,facets:[mn({},z0,{scale:"x"}),mn({},z0,{scale:"y"})]},G0={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:b_,alpha:1,points:{show:NM,filter:null},values:null,min:Vt,max:-Vt,idxs:[],path:null,clip:null};function UM(i,e,t,n,s){return t/10}var S_={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},OM=mn({},S_,{time:!1,ori:1}),H0={};function M_(i,e){let t=H0[i];return t||(t={key:i,plots:[],sub(n){t.plots.push(n)},unsub(n){t.plots=t.plots.filter(s=>s!=n)},pub(n,s,r,o,a,l,c){for(let h=0;h<t.plots.length;h++)t.plots[h]!=s&&t.plots[h].pub(n,s,r,o,a,l,c)}},i!=null&&(H0[i]=t)),t}var co=1,nf=2;function Ar(i,e,t){let n=i.mode,s=i.series[e],r=n==2?i._data[e]:i._data,o=i.scales,a=i.bbox,l=r[0],c=n==2?r[1]:r[e],h=n==2?o[s.facets[0].scale]:o[i.series[0].scale],u=n==2?o[s.facets[1].scale]:o[s.scale],d=a.left,f=a.top,p=a.width,_=a.height,m=i.valToPosH,g=i.valToPosV;return h.ori==0?t(s,l,c,h,u,m,g,d,f,p,_,Ac,uo,Rc,E_,A_):t(s,l,c,h,u,g,m,f,d,_,p,Cc,fo,xf,T_,C_)}function _f(i,e){let t=0,n=0,s=At(i.bands,df);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?n|=1:n|=2)}return[t,n==1?-1:n==2?1:n==3?2:0]}function FM(i,e,t,n,s){let r=i.mode,o=i.series[e],a=r==2?o.facets[1].scale:o.scale,l=i.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function vs(i,e,t,n,s,r){return Ar(i,e,(o,a,l,c,h,u,d,f,p,_,m)=>{let g=o.pxRound,y=c.dir*(c.ori==0?1:-1),T=c.ori==0?uo:fo,b,C;y==1?(b=t,C=n):(b=n,C=t);let A=g(u(a[b],c,_,f)),x=g(d(l[b],h,m,p)),M=g(u(a[C],c,_,f)),k=g(d(r==1?h.max:h.min,h,m,p)),N=new Path2D(s);return T(N,M,k),T(N,A,k),T(N,A,x),N})}function Tc(i,e,t,n,s,r){let o=null;if(i.length>0){o=new Path2D;let a=e==0?Rc:xf,l=t;for(let u=0;u<i.length;u++){let d=i[u];if(d[1]>d[0]){let f=d[0]-l;f>0&&a(o,l,n,f,n+r),l=d[1]}}let c=t+s-l,h=10;c>0&&a(o,l,n-h/2,c,n+r+h)}return o}function kM(i,e,t){let n=i[i.length-1];n&&n[0]==e?n[1]=t:i.push([e,t])}function yf(i,e,t,n,s,r,o){let a=[],l=i.length;for(let c=s==1?t:n;c>=t&&c<=n;c+=s)if(e[c]===null){let u=c,d=c;if(s==1)for(;++c<=n&&e[c]===null;)d=c;else for(;--c>=t&&e[c]===null;)d=c;let f=r(i[u]),p=d==u?f:r(i[d]),_=u-s;f=o<=0&&_>=0&&_<l?r(i[_]):f;let g=d+s;p=o>=0&&g>=0&&g<l?r(i[g]):p,p>=f&&a.push([f,p])}return a}function W0(i){return i==0?e_:i==1?bn:e=>Sr(e,i)}function w_(i){let e=i==0?Ac:Cc,t=i==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},n=i==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,h=0)=>{c==0&&h==0?n(s,r,o,a,l):(c=Ui(c,a/2,l/2),h=Ui(h,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,h),t(s,r,o+l,r,o,h),t(s,r,o,r+a,o,c),s.closePath())}}var Ac=(i,e,t)=>{i.moveTo(e,t)},Cc=(i,e,t)=>{i.moveTo(t,e)},uo=(i,e,t)=>{i.lineTo(e,t)},fo=(i,e,t)=>{i.lineTo(t,e)},Rc=w_(0),xf=w_(1),E_=(i,e,t,n,s,r)=>{i.arc(e,t,n,s,r)},T_=(i,e,t,n,s,r)=>{i.arc(t,e,n,s,r)},A_=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(e,t,n,s,r,o)},C_=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(t,e,s,n,o,r)};function R_(i){return(e,t,n,s,r)=>Ar(e,t,(o,a,l,c,h,u,d,f,p,_,m)=>{let{pxRound:g,points:y}=o,T,b;c.ori==0?(T=Ac,b=E_):(T=Cc,b=T_);let C=Gt(y.width*Rt,3),A=(y.size-y.width)/2*Rt,x=Gt(A*2,3),M=new Path2D,k=new Path2D,{left:N,top:D,width:V,height:W}=e.bbox;Rc(k,N-x,D-x,V+x*2,W+x*2);let U=G=>{if(l[G]!=null){let Z=g(u(a[G],c,_,f)),z=g(d(l[G],h,m,p));T(M,Z+A,z),b(M,Z,z,A,0,yc*2)}};if(r)r.forEach(U);else for(let G=n;G<=s;G++)U(G);return{stroke:C>0?M:null,fill:M,clip:k,flags:co|nf}})}function P_(i){return(e,t,n,s,r,o)=>{n!=s&&(r!=n&&o!=n&&i(e,t,n),r!=s&&o!=s&&i(e,t,s),i(e,t,o))}}var BM=P_(uo),zM=P_(fo);function I_(i){let e=At(i?.alignGaps,0);return(t,n,s,r)=>Ar(t,n,(o,a,l,c,h,u,d,f,p,_,m)=>{[s,r]=Sc(l,s,r);let g=o.pxRound,y=W=>g(u(W,c,_,f)),T=W=>g(d(W,h,m,p)),b,C;c.ori==0?(b=uo,C=BM):(b=fo,C=zM);let A=c.dir*(c.ori==0?1:-1),x={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:co},M=x.stroke,k=!1;if(r-s>=_*4){let W=ue=>t.posToVal(ue,c.key,!0),U=null,G=null,Z,z,ce,j=y(a[A==1?s:r]),K=y(a[s]),ie=y(a[r]),de=W(A==1?K+1:ie-1);for(let ue=A==1?s:r;ue>=s&&ue<=r;ue+=A){let Q=a[ue],xe=(A==1?Q<de:Q>de)?j:y(Q),Re=l[ue];xe==j?Re!=null?(z=Re,U==null?(b(M,xe,T(z)),Z=U=G=z):z<U?U=z:z>G&&(G=z)):Re===null&&(k=!0):(U!=null&&C(M,j,T(U),T(G),T(Z),T(z)),Re!=null?(z=Re,b(M,xe,T(z)),U=G=Z=z):(U=G=null,Re===null&&(k=!0)),j=xe,de=W(j+A))}U!=null&&U!=G&&ce!=j&&C(M,j,T(U),T(G),T(Z),T(z))}else for(let W=A==1?s:r;W>=s&&W<=r;W+=A){let U=l[W];U===null?k=!0:U!=null&&b(M,y(a[W]),T(U))}let[D,V]=_f(t,n);if(o.fill!=null||D!=0){let W=x.fill=new Path2D(M),U=o.fillTo(t,n,o.min,o.max,D),G=T(U),Z=y(a[s]),z=y(a[r]);A==-1&&([z,Z]=[Z,z]),b(W,z,G),b(W,Z,G)}if(!o.spanGaps){let W=[];k&&W.push(...yf(a,l,s,r,A,y,e)),x.gaps=W=o.gaps(t,n,s,r,W),x.clip=Tc(W,c.ori,f,p,_,m)}return V!=0&&(x.band=V==2?[vs(t,n,s,r,M,-1),vs(t,n,s,r,M,1)]:vs(t,n,s,r,M,V)),x})}function VM(i){let e=At(i.align,1),t=At(i.ascDesc,!1),n=At(i.alignGaps,0),s=At(i.extend,!1);return(r,o,a,l)=>Ar(r,o,(c,h,u,d,f,p,_,m,g,y,T)=>{[a,l]=Sc(u,a,l);let b=c.pxRound,{left:C,width:A}=r.bbox,x=K=>b(p(K,d,y,m)),M=K=>b(_(K,f,T,g)),k=d.ori==0?uo:fo,N={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:co},D=N.stroke,V=d.dir*(d.ori==0?1:-1),W=M(u[V==1?a:l]),U=x(h[V==1?a:l]),G=U,Z=U;s&&e==-1&&(Z=C,k(D,Z,W)),k(D,U,W);for(let K=V==1?a:l;K>=a&&K<=l;K+=V){let ie=u[K];if(ie==null)continue;let de=x(h[K]),ue=M(ie);e==1?k(D,de,W):k(D,G,ue),k(D,de,ue),W=ue,G=de}let z=G;s&&e==1&&(z=C+A,k(D,z,W));let[ce,j]=_f(r,o);if(c.fill!=null||ce!=0){let K=N.fill=new Path2D(D),ie=c.fillTo(r,o,c.min,c.max,ce),de=M(ie);k(K,z,de),k(K,Z,de)}if(!c.spanGaps){let K=[];K.push(...yf(h,u,a,l,V,x,n));let ie=c.width*Rt/2,de=t||e==1?ie:-ie,ue=t||e==-1?-ie:ie;K.forEach(Q=>{Q[0]+=de,Q[1]+=ue}),N.gaps=K=c.gaps(r,o,a,l,K),N.clip=Tc(K,d.ori,m,g,y,T)}return j!=0&&(N.band=j==2?[vs(r,o,a,l,D,-1),vs(r,o,a,l,D,1)]:vs(r,o,a,l,D,j)),N})}function $0(i,e,t,n,s,r,o=Vt){if(i.length>1){let a=null;for(let l=0,c=1/0;l<i.length;l++)if(e[l]!==void 0){if(a!=null){let h=Sn(i[l]-i[a]);h<c&&(c=h,o=Sn(t(i[l],n,s,r)-t(i[a],n,s,r)))}a=l}}return o}function GM(i){i=i||Ma;let e=At(i.size,[.6,Vt,1]),t=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=vt(s),o=1-e[0],a=At(e[1],Vt),l=At(e[2],1),c=At(i.disp,Ma),h=At(i.each,f=>{}),{fill:u,stroke:d}=c;return(f,p,_,m)=>Ar(f,p,(g,y,T,b,C,A,x,M,k,N,D)=>{let V=g.pxRound,W=t,U=n*Rt,G=a*Rt,Z=l*Rt,z,ce;b.ori==0?[z,ce]=r(f,p):[ce,z]=r(f,p);let j=b.dir*(b.ori==0?1:-1),K=b.ori==0?Rc:xf,ie=b.ori==0?h:(Ie,Je,lt,Ee,zt,He,Ye)=>{h(Ie,Je,lt,zt,Ee,Ye,He)},de=At(f.bands,df).find(Ie=>Ie.series[0]==p),ue=de!=null?de.dir:0,Q=g.fillTo(f,p,g.min,g.max,ue),ge=V(x(Q,C,D,k)),xe,Re,we,qe=N,at=V(g.width*Rt),We=!1,mt=null,dt=null,rt=null,jt=null;u!=null&&(at==0||d!=null)&&(We=!0,mt=u.values(f,p,_,m),dt=new Map,new Set(mt).forEach(Ie=>{Ie!=null&&dt.set(Ie,new Path2D)}),at>0&&(rt=d.values(f,p,_,m),jt=new Map,new Set(rt).forEach(Ie=>{Ie!=null&&jt.set(Ie,new Path2D)})));let{x0:Ht,size:cn}=c;if(Ht!=null&&cn!=null){W=1,y=Ht.values(f,p,_,m),Ht.unit==2&&(y=y.map(lt=>f.posToVal(M+lt*N,b.key,!0)));let Ie=cn.values(f,p,_,m);cn.unit==2?Re=Ie[0]*N:Re=A(Ie[0],b,N,M)-A(0,b,N,M),qe=$0(y,T,A,b,N,M,qe),we=qe-Re+U}else qe=$0(y,T,A,b,N,M,qe),we=qe*o+U,Re=qe-we;we<1&&(we=0),at>=Re/2&&(at=0),we<5&&(V=e_);let kt=we>0,Cn=qe-we-(kt?at:0);Re=V(Qd(Cn,Z,G)),xe=(W==0?Re/2:W==j?0:Re)-W*j*((W==0?U/2:0)+(kt?at/2:0));let wt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},yn=We?null:new Path2D,en=null;if(de!=null)en=f.data[de.series[1]];else{let{y0:Ie,y1:Je}=c;Ie!=null&&Je!=null&&(T=Je.values(f,p,_,m),en=Ie.values(f,p,_,m))}let hn=z*Re,F=ce*Re;for(let Ie=j==1?_:m;Ie>=_&&Ie<=m;Ie+=j){let Je=T[Ie];if(Je==null)continue;if(en!=null){let $=en[Ie]??0;if(Je-$==0)continue;ge=x($,C,D,k)}let lt=b.distr!=2||c!=null?y[Ie]:Ie,Ee=A(lt,b,N,M),zt=x(At(Je,Q),C,D,k),He=V(Ee-xe),Ye=V(Xn(zt,ge)),R=V(Ui(zt,ge)),S=Ye-R;if(Je!=null){let $=Je<0?F:hn,he=Je<0?hn:F;We?(at>0&&rt[Ie]!=null&&K(jt.get(rt[Ie]),He,R+li(at/2),Re,Xn(0,S-at),$,he),mt[Ie]!=null&&K(dt.get(mt[Ie]),He,R+li(at/2),Re,Xn(0,S-at),$,he)):K(yn,He,R+li(at/2),Re,Xn(0,S-at),$,he),ie(f,p,Ie,He-at/2,R,Re+at,S)}}return at>0?wt.stroke=We?jt:yn:We||(wt._fill=g.width==0?g._fill:g._stroke??g._fill,wt.width=0),wt.fill=We?dt:yn,wt})}function HM(i,e){let t=At(e?.alignGaps,0);return(n,s,r,o)=>Ar(n,s,(a,l,c,h,u,d,f,p,_,m,g)=>{[r,o]=Sc(c,r,o);let y=a.pxRound,T=z=>y(d(z,h,m,p)),b=z=>y(f(z,u,g,_)),C,A,x;h.ori==0?(C=Ac,x=uo,A=A_):(C=Cc,x=fo,A=C_);let M=h.dir*(h.ori==0?1:-1),k=T(l[M==1?r:o]),N=k,D=[],V=[];for(let z=M==1?r:o;z>=r&&z<=o;z+=M)if(c[z]!=null){let j=l[z],K=T(j);D.push(N=K),V.push(b(c[z]))}let W={stroke:i(D,V,C,x,A,y),fill:null,clip:null,band:null,gaps:null,flags:co},U=W.stroke,[G,Z]=_f(n,s);if(a.fill!=null||G!=0){let z=W.fill=new Path2D(U),ce=a.fillTo(n,s,a.min,a.max,G),j=b(ce);x(z,N,j),x(z,k,j)}if(!a.spanGaps){let z=[];z.push(...yf(l,c,r,o,M,T,t)),W.gaps=z=a.gaps(n,s,r,o,z),W.clip=Tc(z,h.ori,p,_,m,g)}return Z!=0&&(W.band=Z==2?[vs(n,s,r,o,U,-1),vs(n,s,r,o,U,1)]:vs(n,s,r,o,U,Z)),W})}function WM(i){return HM($M,i)}function $M(i,e,t,n,s,r){let o=i.length;if(o<2)return null;let a=new Path2D;if(t(a,i[0],e[0]),o==2)n(a,i[1],e[1]);else{let l=Array(o),c=Array(o-1),h=Array(o-1),u=Array(o-1);for(let d=0;d<o-1;d++)h[d]=e[d+1]-e[d],u[d]=i[d+1]-i[d],c[d]=h[d]/u[d];l[0]=c[0];for(let d=1;d<o-1;d++)c[d]===0||c[d-1]===0||c[d-1]>0!=c[d]>0?l[d]=0:(l[d]=3*(u[d-1]+u[d])/((2*u[d]+u[d-1])/c[d-1]+(u[d]+2*u[d-1])/c[d]),isFinite(l[d])||(l[d]=0));l[o-1]=c[o-2];for(let d=0;d<o-1;d++)s(a,i[d]+u[d]/3,e[d]+l[d]*u[d]/3,i[d+1]-u[d]/3,e[d+1]-l[d+1]*u[d]/3,i[d+1],e[d+1])}return a}var sf=new Set;function q0(){for(let i of sf)i.syncRect(!0)}ho&&(Er(ES,ro,q0),Er(TS,ro,q0,!0),Er(xc,ro,()=>{On.pxRatio=Rt}));var qM=I_(),XM=R_();function X0(i,e,t,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>rf(r,o,e,t))}function YM(i,e){return i.map((t,n)=>n==0?{}:mn({},e,t))}function rf(i,e,t,n){return mn({},e==0?t:n,i)}function L_(i,e,t){return e==null?ao:[e,t]}var ZM=L_;function jM(i,e,t){return e==null?ao:vc(e,t,hf,!0)}function D_(i,e,t,n){return e==null?ao:Mc(e,t,i.scales[n].log,!1)}var JM=D_;function N_(i,e,t,n){return e==null?ao:cf(e,t,i.scales[n].log,!1)}var KM=N_;function QM(i,e,t,n,s){let r=Xn(E0(i),E0(e)),o=e-i,a=Ni(s/n*o,t);do{let l=t[a],c=n*l/o;if(c>=s&&r+(l<5?Ys.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function Y0(i){let e,t;return i=i.replace(/(\d+)px/,(n,s)=>(e=bn((t=+s)*Rt))+"px"),[i,e,t]}function ew(i){i.show&&[i.font,i.labelFont].forEach(e=>{let t=Gt(e[2]*Rt,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function On(i,e,t){let n={mode:At(i.mode,1)},s=n.mode;function r(v,w,P,L){let H=w.valToPct(v);return L+P*(w.dir==-1?1-H:H)}function o(v,w,P,L){let H=w.valToPct(v);return L+P*(w.dir==-1?H:1-H)}function a(v,w,P,L){return w.ori==0?r(v,w,P,L):o(v,w,P,L)}n.valToPosH=r,n.valToPosV=o;let l=!1;n.status=0;let c=n.root=bi(aS);if(i.id!=null&&(c.id=i.id),ai(c,i.class),i.title){let v=bi(hS,c);v.textContent=i.title}let h=Di("canvas"),u=n.ctx=h.getContext("2d"),d=bi(uS,c);Er("click",d,v=>{v.target===p&&($t!=Xr||Jt!=Yr)&&Un.click(n,v)},!0);let f=n.under=bi(dS,d);d.appendChild(h);let p=n.over=bi(fS,d);i=lo(i);let _=+At(i.pxAlign,1),m=W0(_);(i.plugins||[]).forEach(v=>{v.opts&&(i=v.opts(n,i)||i)});let g=i.ms||.001,y=n.series=s==1?X0(i.series||[],F0,G0,!1):YM(i.series||[null],V0),T=n.axes=X0(i.axes||[],O0,B0,!0),b=n.scales={},C=n.bands=i.bands||[];C.forEach(v=>{v.fill=vt(v.fill||null),v.dir=At(v.dir,-1)});let A=s==2?y[1].facets[0].scale:y[0].scale,x={axes:ms,series:_t},M=(i.drawOrder||["axes","series"]).map(v=>x[v]);function k(v){let w=v.distr==3?P=>xs(P>0?P:v.clamp(n,P,v.min,v.max,v.key)):v.distr==4?P=>$d(P,v.asinh):v.distr==100?P=>v.fwd(P):P=>P;return P=>{let L=w(P),{_min:H,_max:Y}=v,oe=Y-H;return(L-H)/oe}}function N(v){let w=b[v];if(w==null){let P=(i.scales||Ma)[v]||Ma;if(P.from!=null){N(P.from);let L=mn({},b[P.from],P,{key:v});L.valToPct=k(L),b[v]=L}else{w=b[v]=mn({},v==A?S_:OM,P),w.key=v;let L=w.time,H=w.range,Y=Xs(H);if((v!=A||s==2&&!L)&&(Y&&(H[0]==null||H[1]==null)&&(H={min:H[0]==null?S0:{mode:1,hard:H[0],soft:H[0]},max:H[1]==null?S0:{mode:1,hard:H[1],soft:H[1]}},Y=!1),!Y&&Ec(H))){let oe=H;H=(fe,be,Oe)=>be==null?ao:vc(be,Oe,oe)}w.range=vt(H||(L?ZM:v==A?w.distr==3?JM:w.distr==4?KM:L_:w.distr==3?D_:w.distr==4?N_:jM)),w.auto=vt(Y?!1:w.auto),w.clamp=vt(w.clamp||UM),w._min=w._max=null,w.valToPct=k(w)}}}N("x"),N("y"),s==1&&y.forEach(v=>{N(v.scale)}),T.forEach(v=>{N(v.scale)});for(let v in i.scales)N(v);let D=b[A],V=D.distr,W,U;D.ori==0?(ai(c,lS),W=r,U=o):(ai(c,cS),W=o,U=r);let G={};for(let v in b){let w=b[v];(w.min!=null||w.max!=null)&&(G[v]={min:w.min,max:w.max},w.min=w.max=null)}let Z=i.tzDate||(v=>new Date(bn(v/g))),z=i.fmtDate||ff,ce=g==1?lM(Z):uM(Z),j=D0(Z,L0(g==1?aM:hM,z)),K=U0(Z,N0(fM,z)),ie=[],de=n.legend=mn({},gM,i.legend),ue=n.cursor=mn({},SM,{drag:{y:s==2}},i.cursor),Q=de.show,ge=ue.show,xe=de.markers;de.idxs=ie,xe.width=vt(xe.width),xe.dash=vt(xe.dash),xe.stroke=vt(xe.stroke),xe.fill=vt(xe.fill);let Re,we,qe,at=[],We=[],mt,dt=!1,rt={};if(de.live){let v=y[1]?y[1].values:null;dt=v!=null,mt=dt?v(n,1,0):{_:0};for(let w in mt)rt[w]=af}if(Q)if(Re=Di("table",xS,c),qe=Di("tbody",null,Re),de.mount(n,Re),dt){we=Di("thead",null,Re,qe);let v=Di("tr",null,we);Di("th",null,v);for(var jt in mt)Di("th",c0,v).textContent=jt}else ai(Re,bS),de.live&&ai(Re,vS);let Ht={show:!0},cn={show:!1};function kt(v,w){if(w==0&&(dt||!de.live||s==2))return ao;let P=[],L=Di("tr",SS,qe,qe.childNodes[w]);ai(L,v.class),v.show||ai(L,wr);let H=Di("th",null,L);if(xe.show){let fe=bi(MS,H);if(w>0){let be=xe.width(n,w);be&&(fe.style.border=be+"px "+xe.dash(n,w)+" "+xe.stroke(n,w)),fe.style.background=xe.fill(n,w)}}let Y=bi(c0,H);v.label instanceof HTMLElement?Y.appendChild(v.label):Y.textContent=v.label,w>0&&(xe.show||(Y.style.color=v.width>0?xe.stroke(n,w):xe.fill(n,w)),wt("click",H,fe=>{if(ue._lock)return;et(fe);let be=y.indexOf(v);if((fe.ctrlKey||fe.metaKey)!=de.isolate){let Oe=y.some((Fe,Be)=>Be>0&&Be!=be&&Fe.show);y.forEach((Fe,Be)=>{Be>0&&Zi(Be,Oe?Be==be?Ht:cn:Ht,!0,pn.setSeries)})}else Zi(be,{show:!v.show},!0,pn.setSeries)},!1),tt&&wt(f0,H,fe=>{ue._lock||(et(fe),Zi(y.indexOf(v),jr,!0,pn.setSeries))},!1));for(var oe in mt){let fe=Di("td",wS,L);fe.textContent="--",P.push(fe)}return[L,P]}let Cn=new Map;function wt(v,w,P,L=!0){let H=Cn.get(w)||{},Y=ue.bind[v](n,w,P,L);Y&&(Er(v,w,H[v]=Y),Cn.set(w,H))}function yn(v,w,P){let L=Cn.get(w)||{};for(let H in L)(v==null||H==v)&&(Kd(H,w,L[H]),delete L[H]);v==null&&Cn.delete(w)}let en=0,hn=0,F=0,Ie=0,Je=0,lt=0,Ee=Je,zt=lt,He=F,Ye=Ie,R=0,S=0,$=0,he=0;n.bbox={};let re=!1,ye=!1,ve=!1,ee=!1,ne=!1,pe=!1;function O(v,w,P){(P||v!=n.width||w!=n.height)&&se(v,w),ft(!1),ve=!0,ye=!0,Fn()}function se(v,w){n.width=en=F=v,n.height=hn=Ie=w,Je=lt=0,Se(),$e();let P=n.bbox;R=P.left=Sr(Je*Rt,.5),S=P.top=Sr(lt*Rt,.5),$=P.width=Sr(F*Rt,.5),he=P.height=Sr(Ie*Rt,.5)}let te=3;function Te(){let v=!1,w=0;for(;!v;){w++;let P=Wr(w),L=Yi(w);v=w==te||P&&L,v||(se(n.width,n.height),ye=!0)}}function _e({width:v,height:w}){O(v,w)}n.setSize=_e;function Se(){let v=!1,w=!1,P=!1,L=!1;T.forEach((H,Y)=>{if(H.show&&H._show){let{side:oe,_size:fe}=H,be=oe%2,Oe=H.label!=null?H.labelSize:0,Fe=fe+Oe;Fe>0&&(be?(F-=Fe,oe==3?(Je+=Fe,L=!0):P=!0):(Ie-=Fe,oe==0?(lt+=Fe,v=!0):w=!0))}}),qi[0]=v,qi[1]=P,qi[2]=w,qi[3]=L,F-=Ri[1]+Ri[3],Je+=Ri[3],Ie-=Ri[2]+Ri[0],lt+=Ri[0]}function $e(){let v=Je+F,w=lt+Ie,P=Je,L=lt;function H(Y,oe){switch(Y){case 1:return v+=oe,v-oe;case 2:return w+=oe,w-oe;case 3:return P-=oe,P+oe;case 0:return L-=oe,L+oe}}T.forEach((Y,oe)=>{if(Y.show&&Y._show){let fe=Y.side;Y._pos=H(fe,Y._size),Y.label!=null&&(Y._lpos=H(fe,Y.labelSize))}})}if(ue.dataIdx==null){let v=ue.hover,w=v.skip=new Set(v.skip??[]);w.add(void 0);let P=v.prox=vt(v.prox),L=v.bias??=0;ue.dataIdx=(H,Y,oe,fe)=>{if(Y==0)return oe;let be=oe,Oe=P(H,Y,oe,fe)??Vt,Fe=Oe>=0&&Oe<Vt,Be=D.ori==0?F:Ie,ot=ue.left,Ct=e[0],Tt=e[Y];if(w.has(Tt[oe])){be=null;let yt=null,Ke=null,Xe;if(L==0||L==-1)for(Xe=oe;yt==null&&Xe-- >0;)w.has(Tt[Xe])||(yt=Xe);if(L==0||L==1)for(Xe=oe;Ke==null&&Xe++<Tt.length;)w.has(Tt[Xe])||(Ke=Xe);if(yt!=null||Ke!=null)if(Fe){let Xt=yt==null?-1/0:W(Ct[yt],D,Be,0),sn=Ke==null?1/0:W(Ct[Ke],D,Be,0),Ln=ot-Xt,Bt=sn-ot;Ln<=Bt?Ln<=Oe&&(be=yt):Bt<=Oe&&(be=Ke)}else be=Ke==null?yt:yt==null?Ke:oe-yt<=Ke-oe?yt:Ke}else Fe&&Sn(ot-W(Ct[oe],D,Be,0))>Oe&&(be=null);return be}}let et=v=>{ue.event=v};ue.idxs=ie,ue._lock=!1;let le=ue.points;le.show=vt(le.show),le.size=vt(le.size),le.stroke=vt(le.stroke),le.width=vt(le.width),le.fill=vt(le.fill);let ze=n.focus=mn({},i.focus||{alpha:.3},ue.focus),tt=ze.prox>=0,Pe=tt&&le.one,ct=[],Wt=[],Gn=[];function Ko(v,w){let P=le.show(n,w);if(P instanceof HTMLElement)return ai(P,yS),ai(P,v.class),is(P,-10,-10,F,Ie),p.insertBefore(P,ct[w]),P}function Vr(v,w){if(s==1||w>0){let P=s==1&&b[v.scale].time,L=v.value;v.value=P?C0(L)?U0(Z,N0(L,z)):L||K:L||LM,v.label=v.label||(P?wM:MM)}if(Pe||w>0){v.width=v.width==null?1:v.width,v.paths=v.paths||qM||OS,v.fillTo=vt(v.fillTo||FM),v.pxAlign=+At(v.pxAlign,_),v.pxRound=W0(v.pxAlign),v.stroke=vt(v.stroke||null),v.fill=vt(v.fill||null),v._stroke=v._fill=v._paths=v._focus=null;let P=DM(Xn(1,v.width),1),L=v.points=mn({},{size:P,width:Xn(1,P*.2),stroke:v.stroke,space:P*2,paths:XM,_stroke:null,_fill:null},v.points);L.show=vt(L.show),L.filter=vt(L.filter),L.fill=vt(L.fill),L.stroke=vt(L.stroke),L.paths=vt(L.paths),L.pxAlign=v.pxAlign}if(Q){let P=kt(v,w);at.splice(w,0,P[0]),We.splice(w,0,P[1]),de.values.push(null)}if(ge){ie.splice(w,0,null);let P=null;Pe?w==0&&(P=Ko(v,w)):w>0&&(P=Ko(v,w)),ct.splice(w,0,P),Wt.splice(w,0,0),Gn.splice(w,0,0)}In("addSeries",w)}function sd(v,w){w=w??y.length,v=s==1?rf(v,w,F0,G0):rf(v,w,{},V0),y.splice(w,0,v),Vr(y[w],w)}n.addSeries=sd;function Il(v){if(y.splice(v,1),Q){de.values.splice(v,1),We.splice(v,1);let w=at.splice(v,1)[0];yn(null,w.firstChild),w.remove()}ge&&(ie.splice(v,1),ct.splice(v,1)[0].remove(),Wt.splice(v,1),Gn.splice(v,1)),In("delSeries",v)}n.delSeries=Il;let qi=[!1,!1,!1,!1];function ds(v,w){if(v._show=v.show,v.show){let P=v.side%2,L=b[v.scale];L==null&&(v.scale=P?y[1].scale:A,L=b[v.scale]);let H=L.time;v.size=vt(v.size),v.space=vt(v.space),v.rotate=vt(v.rotate),Xs(v.incrs)&&v.incrs.forEach(oe=>{!Ys.has(oe)&&Ys.set(oe,i_(oe))}),v.incrs=vt(v.incrs||(L.distr==2?sM:H?g==1?oM:cM:Mr)),v.splits=vt(v.splits||(H&&L.distr==1?ce:L.distr==3?ef:L.distr==4?AM:TM)),v.stroke=vt(v.stroke),v.grid.stroke=vt(v.grid.stroke),v.ticks.stroke=vt(v.ticks.stroke),v.border.stroke=vt(v.border.stroke);let Y=v.values;v.values=Xs(Y)&&!Xs(Y[0])?vt(Y):H?Xs(Y)?D0(Z,L0(Y,z)):C0(Y)?dM(Z,Y):Y||j:Y||EM,v.filter=vt(v.filter||(L.distr>=3&&L.log==10?PM:L.distr==3&&L.log==2?IM:t_)),v.font=Y0(v.font),v.labelFont=Y0(v.labelFont),v._size=v.size(n,null,w,0),v._space=v._rotate=v._incrs=v._found=v._splits=v._values=null,v._size>0&&(qi[w]=!0,v._el=bi(pS,d))}}function fs(v,w,P,L){let[H,Y,oe,fe]=P,be=w%2,Oe=0;return be==0&&(fe||Y)&&(Oe=w==0&&!H||w==2&&!oe?bn(O0.size/3):0),be==1&&(H||oe)&&(Oe=w==1&&!Y||w==3&&!fe?bn(B0.size/2):0),Oe}let Qo=n.padding=(i.padding||[fs,fs,fs,fs]).map(v=>vt(At(v,fs))),Ri=n._padding=Qo.map((v,w)=>v(n,w,qi,0)),tn,on=null,an=null,Xi=s==1?y[0].idxs:null,ni=null,Fs=!1;function ea(v,w){if(e=v??[],n.data=n._data=e,s==2){tn=0;for(let P=1;P<y.length;P++)tn+=e[P][0].length}else{e.length==0&&(n.data=n._data=e=[[]]),ni=e[0],tn=ni.length;let P=e;if(V==2){P=e.slice();let L=P[0]=Array(tn);for(let H=0;H<tn;H++)L[H]=H}n._data=e=P}if(ft(!0),In("setData"),V==2&&(ve=!0),w!==!1){let P=D;P.auto(n,Fs)?ta():zs(A,P.min,P.max),ee=ee||ue.left>=0,pe=!0,Fn()}}n.setData=ea;function ta(){Fs=!0;let v,w;s==1&&(tn>0?(on=Xi[0]=0,an=Xi[1]=tn-1,v=e[0][on],w=e[0][an],V==2?(v=on,w=an):v==w&&(V==3?[v,w]=Mc(v,v,D.log,!1):V==4?[v,w]=cf(v,v,D.log,!1):D.time?w=v+bn(86400/g):[v,w]=vc(v,w,hf,!0))):(on=Xi[0]=v=null,an=Xi[1]=w=null)),zs(A,v,w)}let Gr,ks,Hr,E,B,J,q,X,Ae,Le;function Ce(v,w,P,L,H,Y){v??=u0,P??=df,L??="butt",H??=u0,Y??="round",v!=Gr&&(u.strokeStyle=Gr=v),H!=ks&&(u.fillStyle=ks=H),w!=Hr&&(u.lineWidth=Hr=w),Y!=B&&(u.lineJoin=B=Y),L!=J&&(u.lineCap=J=L),P!=E&&u.setLineDash(E=P)}function De(v,w,P,L){w!=ks&&(u.fillStyle=ks=w),v!=q&&(u.font=q=v),P!=X&&(u.textAlign=X=P),L!=Ae&&(u.textBaseline=Ae=L)}function Ge(v,w,P,L,H=0){if(L.length>0&&v.auto(n,Fs)&&(w==null||w.min==null)){let Y=At(on,0),oe=At(an,L.length-1),fe=P.min==null?PS(L,Y,oe,H,v.distr==3):[P.min,P.max];v.min=Ui(v.min,P.min=fe[0]),v.max=Xn(v.max,P.max=fe[1])}}let nt={min:null,max:null};function gt(){for(let L in b){let H=b[L];G[L]==null&&(H.min==null||G[A]!=null&&H.auto(n,Fs))&&(G[L]=nt)}for(let L in b){let H=b[L];G[L]==null&&H.from!=null&&G[H.from]!=null&&(G[L]=nt)}G[A]!=null&&ft(!0);let v={};for(let L in G){let H=G[L];if(H!=null){let Y=v[L]=lo(b[L],BS);if(H.min!=null)mn(Y,H);else if(L!=A||s==2)if(tn==0&&Y.from==null){let oe=Y.range(n,null,null,L);Y.min=oe[0],Y.max=oe[1]}else Y.min=Vt,Y.max=-Vt}}if(tn>0){y.forEach((L,H)=>{if(s==1){let Y=L.scale,oe=G[Y];if(oe==null)return;let fe=v[Y];if(H==0){let be=fe.range(n,fe.min,fe.max,Y);fe.min=be[0],fe.max=be[1],on=Ni(fe.min,e[0]),an=Ni(fe.max,e[0]),an-on>1&&(e[0][on]<fe.min&&on++,e[0][an]>fe.max&&an--),L.min=ni[on],L.max=ni[an]}else L.show&&L.auto&&Ge(fe,oe,L,e[H],L.sorted);L.idxs[0]=on,L.idxs[1]=an}else if(H>0&&L.show&&L.auto){let[Y,oe]=L.facets,fe=Y.scale,be=oe.scale,[Oe,Fe]=e[H],Be=v[fe],ot=v[be];Be!=null&&Ge(Be,G[fe],Y,Oe,Y.sorted),ot!=null&&Ge(ot,G[be],oe,Fe,oe.sorted),L.min=oe.min,L.max=oe.max}});for(let L in v){let H=v[L],Y=G[L];if(H.from==null&&(Y==null||Y.min==null)){let oe=H.range(n,H.min==Vt?null:H.min,H.max==-Vt?null:H.max,L);H.min=oe[0],H.max=oe[1]}}}for(let L in v){let H=v[L];if(H.from!=null){let Y=v[H.from];if(Y.min==null)H.min=H.max=null;else{let oe=H.range(n,Y.min,Y.max,L);H.min=oe[0],H.max=oe[1]}}}let w={},P=!1;for(let L in v){let H=v[L],Y=b[L];if(Y.min!=H.min||Y.max!=H.max){Y.min=H.min,Y.max=H.max;let oe=Y.distr;Y._min=oe==3?xs(Y.min):oe==4?$d(Y.min,Y.asinh):oe==100?Y.fwd(Y.min):Y.min,Y._max=oe==3?xs(Y.max):oe==4?$d(Y.max,Y.asinh):oe==100?Y.fwd(Y.max):Y.max,w[L]=P=!0}}if(P){y.forEach((L,H)=>{s==2?H>0&&w.y&&(L._paths=null):w[L.scale]&&(L._paths=null)});for(let L in w)ve=!0,In("setScale",L);ge&&ue.left>=0&&(ee=pe=!0)}for(let L in G)G[L]=null}function Ve(v){let w=Qd(on-1,0,tn-1),P=Qd(an+1,0,tn-1);for(;v[w]==null&&w>0;)w--;for(;v[P]==null&&P<tn-1;)P++;return[w,P]}function _t(){if(tn>0){let v=y.some(w=>w._focus)&&Le!=ze.alpha;v&&(u.globalAlpha=Le=ze.alpha),y.forEach((w,P)=>{if(P>0&&w.show&&(Qt(P,!1),Qt(P,!0),w._paths==null)){let L=Le;Le!=w.alpha&&(u.globalAlpha=Le=w.alpha);let H=s==2?[0,e[P][0].length-1]:Ve(e[P]);w._paths=w.paths(n,P,H[0],H[1]),Le!=L&&(u.globalAlpha=Le=L)}}),y.forEach((w,P)=>{if(P>0&&w.show){let L=Le;Le!=w.alpha&&(u.globalAlpha=Le=w.alpha),w._paths!=null&&Ut(P,!1);{let H=w._paths!=null?w._paths.gaps:null,Y=w.points.show(n,P,on,an,H),oe=w.points.filter(n,P,Y,H);(Y||oe)&&(w.points._paths=w.points.paths(n,P,on,an,oe),Ut(P,!0))}Le!=L&&(u.globalAlpha=Le=L),In("drawSeries",P)}}),v&&(u.globalAlpha=Le=1)}}function Qt(v,w){let P=w?y[v].points:y[v];P._stroke=P.stroke(n,v),P._fill=P.fill(n,v)}function Ut(v,w){let P=w?y[v].points:y[v],{stroke:L,fill:H,clip:Y,flags:oe,_stroke:fe=P._stroke,_fill:be=P._fill,_width:Oe=P.width}=P._paths;Oe=Gt(Oe*Rt,3);let Fe=null,Be=Oe%2/2;w&&be==null&&(be=Oe>0?"#fff":fe);let ot=P.pxAlign==1&&Be>0;if(ot&&u.translate(Be,Be),!w){let Ct=R-Oe/2,Tt=S-Oe/2,yt=$+Oe,Ke=he+Oe;Fe=new Path2D,Fe.rect(Ct,Tt,yt,Ke)}w?ke(fe,Oe,P.dash,P.cap,be,L,H,oe,Y):Ot(v,fe,Oe,P.dash,P.cap,be,L,H,oe,Fe,Y),ot&&u.translate(-Be,-Be)}function Ot(v,w,P,L,H,Y,oe,fe,be,Oe,Fe){let Be=!1;be!=0&&C.forEach((ot,Ct)=>{if(ot.series[0]==v){let Tt=y[ot.series[1]],yt=e[ot.series[1]],Ke=(Tt._paths||Ma).band;Xs(Ke)&&(Ke=ot.dir==1?Ke[0]:Ke[1]);let Xe,Xt=null;Tt.show&&Ke&&LS(yt,on,an)?(Xt=ot.fill(n,Ct)||Y,Xe=Tt._paths.clip):Ke=null,ke(w,P,L,H,Xt,oe,fe,be,Oe,Fe,Xe,Ke),Be=!0}}),Be||ke(w,P,L,H,Y,oe,fe,be,Oe,Fe)}let xn=co|nf;function ke(v,w,P,L,H,Y,oe,fe,be,Oe,Fe,Be){Ce(v,w,P,L,H),(be||Oe||Be)&&(u.save(),be&&u.clip(be),Oe&&u.clip(Oe)),Be?(fe&xn)==xn?(u.clip(Be),Fe&&u.clip(Fe),xt(H,oe),un(v,Y,w)):fe&nf?(xt(H,oe),u.clip(Be),un(v,Y,w)):fe&co&&(u.save(),u.clip(Be),Fe&&u.clip(Fe),xt(H,oe),u.restore(),un(v,Y,w)):(xt(H,oe),un(v,Y,w)),(be||Oe||Be)&&u.restore()}function un(v,w,P){P>0&&(w instanceof Map?w.forEach((L,H)=>{u.strokeStyle=Gr=H,u.stroke(L)}):w!=null&&v&&u.stroke(w))}function xt(v,w){w instanceof Map?w.forEach((P,L)=>{u.fillStyle=ks=L,u.fill(P)}):w!=null&&v&&u.fill(w)}function ps(v,w,P,L){let H=T[v],Y;if(L<=0)Y=[0,0];else{let oe=H._space=H.space(n,v,w,P,L),fe=H._incrs=H.incrs(n,v,w,P,L,oe);Y=QM(w,P,fe,L,oe)}return H._found=Y}function dn(v,w,P,L,H,Y,oe,fe,be,Oe){let Fe=oe%2/2;_==1&&u.translate(Fe,Fe),Ce(fe,oe,be,Oe,fe),u.beginPath();let Be,ot,Ct,Tt,yt=H+(L==0||L==3?-Y:Y);P==0?(ot=H,Tt=yt):(Be=H,Ct=yt);for(let Ke=0;Ke<v.length;Ke++)w[Ke]!=null&&(P==0?Be=Ct=v[Ke]:ot=Tt=v[Ke],u.moveTo(Be,ot),u.lineTo(Ct,Tt));u.stroke(),_==1&&u.translate(-Fe,-Fe)}function Wr(v){let w=!0;return T.forEach((P,L)=>{if(!P.show)return;let H=b[P.scale];if(H.min==null){P._show&&(w=!1,P._show=!1,ft(!1));return}else P._show||(w=!1,P._show=!0,ft(!1));let Y=P.side,oe=Y%2,{min:fe,max:be}=H,[Oe,Fe]=ps(L,fe,be,oe==0?F:Ie);if(Fe==0)return;let Be=H.distr==2,ot=P._splits=P.splits(n,L,fe,be,Oe,Fe,Be),Ct=H.distr==2?ot.map(Xe=>ni[Xe]):ot,Tt=H.distr==2?ni[ot[1]]-ni[ot[0]]:Oe,yt=P._values=P.values(n,P.filter(n,Ct,L,Fe,Tt),L,Fe,Tt);P._rotate=Y==2?P.rotate(n,yt,L,Fe):0;let Ke=P._size;P._size=Si(P.size(n,yt,L,v)),Ke!=null&&P._size!=Ke&&(w=!1)}),w}function Yi(v){let w=!0;return Qo.forEach((P,L)=>{let H=P(n,L,qi,v);H!=Ri[L]&&(w=!1),Ri[L]=H}),w}function ms(){for(let v=0;v<T.length;v++){let w=T[v];if(!w.show||!w._show)continue;let P=w.side,L=P%2,H,Y,oe=w.stroke(n,v),fe=P==0||P==3?-1:1,[be,Oe]=w._found;if(w.label!=null){let $n=w.labelGap*fe,ri=bn((w._lpos+$n)*Rt);De(w.labelFont[0],oe,"center",P==2?"top":h0),u.save(),L==1?(H=Y=0,u.translate(ri,bn(S+he/2)),u.rotate((P==3?-yc:yc)/2)):(H=bn(R+$/2),Y=ri);let pr=Q0(w.label)?w.label(n,v,be,Oe):w.label;u.fillText(pr,H,Y),u.restore()}if(Oe==0)continue;let Fe=b[w.scale],Be=L==0?$:he,ot=L==0?R:S,Ct=w._splits,Tt=Fe.distr==2?Ct.map($n=>ni[$n]):Ct,yt=Fe.distr==2?ni[Ct[1]]-ni[Ct[0]]:be,Ke=w.ticks,Xe=w.border,Xt=Ke.show?Ke.size:0,sn=bn(Xt*Rt),Ln=bn((w.alignTo==2?w._size-Xt-w.gap:w.gap)*Rt),Bt=w._rotate*-yc/180,rn=m(w._pos*Rt),ii=(sn+Ln)*fe,Wn=rn+ii;Y=L==0?Wn:0,H=L==1?Wn:0;let yi=w.font[0],Pi=w.align==1?io:w.align==2?Gd:Bt>0?io:Bt<0?Gd:L==0?"center":P==3?Gd:io,Ji=Bt||L==1?"middle":P==2?"top":h0;De(yi,oe,Pi,Ji);let si=w.font[1]*w.lineGap,xi=Ct.map($n=>m(a($n,Fe,Be,ot))),Ii=w._values;for(let $n=0;$n<Ii.length;$n++){let ri=Ii[$n];if(ri!=null){L==0?H=xi[$n]:Y=xi[$n],ri=""+ri;let pr=ri.indexOf(`
`)==-1?[ri]:ri.split(/\n/gm);for(let qn=0;qn<pr.length;qn++){let Hm=pr[qn];Bt?(u.save(),u.translate(H,Y+qn*si),u.rotate(Bt),u.fillText(Hm,0,0),u.restore()):u.fillText(Hm,H,Y+qn*si)}}}Ke.show&&dn(xi,Ke.filter(n,Tt,v,Oe,yt),L,P,rn,sn,Gt(Ke.width*Rt,3),Ke.stroke(n,v),Ke.dash,Ke.cap);let Ki=w.grid;Ki.show&&dn(xi,Ki.filter(n,Tt,v,Oe,yt),L,L==0?2:1,L==0?S:R,L==0?he:$,Gt(Ki.width*Rt,3),Ki.stroke(n,v),Ki.dash,Ki.cap),Xe.show&&dn([rn],[1],L==0?1:0,L==0?1:2,L==1?S:R,L==1?he:$,Gt(Xe.width*Rt,3),Xe.stroke(n,v),Xe.dash,Xe.cap)}In("drawAxes")}function ft(v){y.forEach((w,P)=>{P>0&&(w._paths=null,v&&(s==1?(w.min=null,w.max=null):w.facets.forEach(L=>{L.min=null,L.max=null})))})}let nn=!1,Hn=!1,Ft=[];function fn(){Hn=!1;for(let v=0;v<Ft.length;v++)In(...Ft[v]);Ft.length=0}function Fn(){nn||(qS(Em),nn=!0)}function Ll(v,w=!1){nn=!0,Hn=w,v(n),Em(),w&&Ft.length>0&&queueMicrotask(fn)}n.batch=Ll;function Em(){if(re&&(gt(),re=!1),ve&&(Te(),ve=!1),ye){if(Yt(f,io,Je),Yt(f,"top",lt),Yt(f,xa,F),Yt(f,va,Ie),Yt(p,io,Je),Yt(p,"top",lt),Yt(p,xa,F),Yt(p,va,Ie),Yt(d,xa,en),Yt(d,va,hn),h.width=bn(en*Rt),h.height=bn(hn*Rt),T.forEach(({_el:v,_show:w,_size:P,_pos:L,side:H})=>{if(v!=null)if(w){let Y=H===3||H===0?P:0,oe=H%2==1;Yt(v,oe?"left":"top",L-Y),Yt(v,oe?"width":"height",P),Yt(v,oe?"top":"left",oe?lt:Je),Yt(v,oe?"height":"width",oe?Ie:F),Jd(v,wr)}else ai(v,wr)}),Gr=ks=Hr=B=J=q=X=Ae=E=null,Le=1,sa(!0),Je!=Ee||lt!=zt||F!=He||Ie!=Ye){ft(!1);let v=F/He,w=Ie/Ye;if(ge&&!ee&&ue.left>=0){ue.left*=v,ue.top*=w,$r&&is($r,bn(ue.left),0,F,Ie),qr&&is(qr,0,bn(ue.top),F,Ie);for(let P=0;P<ct.length;P++){let L=ct[P];L!=null&&(Wt[P]*=v,Gn[P]*=w,is(L,Si(Wt[P]),Si(Gn[P]),F,Ie))}}if(qt.show&&!ne&&qt.left>=0&&qt.width>0){qt.left*=v,qt.width*=v,qt.top*=w,qt.height*=w;for(let P in hd)Yt(Zr,P,qt[P])}Ee=Je,zt=lt,He=F,Ye=Ie}In("setSize"),ye=!1}en>0&&hn>0&&(u.clearRect(0,0,h.width,h.height),In("drawClear"),M.forEach(v=>v()),In("draw")),qt.show&&ne&&(Dl(qt),ne=!1),ge&&ee&&(fr(null,!0,!1),ee=!1),de.show&&de.live&&pe&&(ld(),pe=!1),l||(l=!0,n.status=1,In("ready")),Fs=!1,nn=!1}n.redraw=(v,w)=>{ve=w||!1,v!==!1?zs(A,D.min,D.max):Fn()};function rd(v,w){let P=b[v];if(P.from==null){if(tn==0){let L=P.range(n,w.min,w.max,v);w.min=L[0],w.max=L[1]}if(w.min>w.max){let L=w.min;w.min=w.max,w.max=L}if(tn>1&&w.min!=null&&w.max!=null&&w.max-w.min<1e-16)return;v==A&&P.distr==2&&tn>0&&(w.min=Ni(w.min,e[0]),w.max=Ni(w.max,e[0]),w.min==w.max&&w.max++),G[v]=w,re=!0,Fn()}}n.setScale=rd;let od,ad,$r,qr,Tm,Am,Xr,Yr,Cm,Rm,$t,Jt,Bs=!1,Un=ue.drag,Rn=Un.x,Pn=Un.y;ge&&(ue.x&&(od=bi(gS,p)),ue.y&&(ad=bi(_S,p)),D.ori==0?($r=od,qr=ad):($r=ad,qr=od),$t=ue.left,Jt=ue.top);let qt=n.select=mn({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),Zr=qt.show?bi(mS,qt.over?p:f):null;function Dl(v,w){if(qt.show){for(let P in v)qt[P]=v[P],P in hd&&Yt(Zr,P,v[P]);w!==!1&&In("setSelect")}}n.setSelect=Dl;function Hv(v){if(y[v].show)Q&&Jd(at[v],wr);else if(Q&&ai(at[v],wr),ge){let P=Pe?ct[0]:ct[v];P!=null&&is(P,-10,-10,F,Ie)}}function zs(v,w,P){rd(v,{min:w,max:P})}function Zi(v,w,P,L){w.focus!=null&&Yv(v),w.show!=null&&y.forEach((H,Y)=>{Y>0&&(v==Y||v==null)&&(H.show=w.show,Hv(Y),s==2?(zs(H.facets[0].scale,null,null),zs(H.facets[1].scale,null,null)):zs(H.scale,null,null),Fn())}),P!==!1&&In("setSeries",v,w),L&&ra("setSeries",n,v,w)}n.setSeries=Zi;function Wv(v,w){mn(C[v],w)}function $v(v,w){v.fill=vt(v.fill||null),v.dir=At(v.dir,-1),w=w??C.length,C.splice(w,0,v)}function qv(v){v==null?C.length=0:C.splice(v,1)}n.addBand=$v,n.setBand=Wv,n.delBand=qv;function Xv(v,w){y[v].alpha=w,ge&&ct[v]!=null&&(ct[v].style.opacity=w),Q&&at[v]&&(at[v].style.opacity=w)}let gs,Vs,dr,jr={focus:!0};function Yv(v){if(v!=dr){let w=v==null,P=ze.alpha!=1;y.forEach((L,H)=>{if(s==1||H>0){let Y=w||H==0||H==v;L._focus=w?null:Y,P&&Xv(H,Y?1:ze.alpha)}}),dr=v,P&&Fn()}}Q&&tt&&wt(p0,Re,v=>{ue._lock||(et(v),dr!=null&&Zi(null,jr,!0,pn.setSeries))});function ji(v,w,P){let L=b[w];P&&(v=v/Rt-(L.ori==1?lt:Je));let H=F;L.ori==1&&(H=Ie,v=H-v),L.dir==-1&&(v=H-v);let Y=L._min,oe=L._max,fe=v/H,be=Y+(oe-Y)*fe,Oe=L.distr;return Oe==3?oo(10,be):Oe==4?NS(be,L.asinh):Oe==100?L.bwd(be):be}function Zv(v,w){let P=ji(v,A,w);return Ni(P,e[0],on,an)}n.valToIdx=v=>Ni(v,e[0]),n.posToIdx=Zv,n.posToVal=ji,n.valToPos=(v,w,P)=>b[w].ori==0?r(v,b[w],P?$:F,P?R:0):o(v,b[w],P?he:Ie,P?S:0),n.setCursor=(v,w,P)=>{$t=v.left,Jt=v.top,fr(null,w,P)};function Pm(v,w){Yt(Zr,io,qt.left=v),Yt(Zr,xa,qt.width=w)}function Im(v,w){Yt(Zr,"top",qt.top=v),Yt(Zr,va,qt.height=w)}let na=D.ori==0?Pm:Im,ia=D.ori==1?Pm:Im;function jv(){if(Q&&de.live)for(let v=s==2?1:0;v<y.length;v++){if(v==0&&dt)continue;let w=de.values[v],P=0;for(let L in w)We[v][P++].firstChild.nodeValue=w[L]}}function ld(v,w){if(v!=null&&(v.idxs?v.idxs.forEach((P,L)=>{ie[L]=P}):kS(v.idx)||ie.fill(v.idx),de.idx=ie[0]),Q&&de.live){for(let P=0;P<y.length;P++)(P>0||s==1&&!dt)&&Jv(P,ie[P]);jv()}pe=!1,w!==!1&&In("setLegend")}n.setLegend=ld;function Jv(v,w){let P=y[v],L=v==0&&V==2?ni:e[v],H;dt?H=P.values(n,v,w)??rt:(H=P.value(n,w==null?null:L[w],v,w),H=H==null?rt:{_:H}),de.values[v]=H}function fr(v,w,P){Cm=$t,Rm=Jt,[$t,Jt]=ue.move(n,$t,Jt),ue.left=$t,ue.top=Jt,ge&&($r&&is($r,bn($t),0,F,Ie),qr&&is(qr,0,bn(Jt),F,Ie));let L,H=on>an;gs=Vt,Vs=null;let Y=D.ori==0?F:Ie,oe=D.ori==1?F:Ie;if($t<0||tn==0||H){L=ue.idx=null;for(let fe=0;fe<y.length;fe++){let be=ct[fe];be!=null&&is(be,-10,-10,F,Ie)}tt&&Zi(null,jr,!0,v==null&&pn.setSeries),de.live&&(ie.fill(L),pe=!0)}else{let fe,be,Oe;s==1&&(fe=D.ori==0?$t:Jt,be=ji(fe,A),L=ue.idx=Ni(be,e[0],on,an),Oe=W(e[0][L],D,Y,0));let Fe=-10,Be=-10,ot=0,Ct=0,Tt=!0,yt="",Ke="";for(let Xe=s==2?1:0;Xe<y.length;Xe++){let Xt=y[Xe],sn=ie[Xe],Ln=sn==null?null:s==1?e[Xe][sn]:e[Xe][1][sn],Bt=ue.dataIdx(n,Xe,L,be),rn=Bt==null?null:s==1?e[Xe][Bt]:e[Xe][1][Bt];if(pe=pe||rn!=Ln||Bt!=sn,ie[Xe]=Bt,Xe>0&&Xt.show){let ii=Bt==null?-10:Bt==L?Oe:W(s==1?e[0][Bt]:e[Xe][0][Bt],D,Y,0),Wn=rn==null?-10:U(rn,s==1?b[Xt.scale]:b[Xt.facets[1].scale],oe,0);if(tt&&rn!=null){let yi=D.ori==1?$t:Jt,Pi=Sn(ze.dist(n,Xe,Bt,Wn,yi));if(Pi<gs){let Ji=ze.bias;if(Ji!=0){let si=ji(yi,Xt.scale),xi=rn>=0?1:-1,Ii=si>=0?1:-1;Ii==xi&&(Ii==1?Ji==1?rn>=si:rn<=si:Ji==1?rn<=si:rn>=si)&&(gs=Pi,Vs=Xe)}else gs=Pi,Vs=Xe}}if(pe||Pe){let yi,Pi;D.ori==0?(yi=ii,Pi=Wn):(yi=Wn,Pi=ii);let Ji,si,xi,Ii,Ki,$n,ri=!0,pr=le.bbox;if(pr!=null){ri=!1;let qn=pr(n,Xe);xi=qn.left,Ii=qn.top,Ji=qn.width,si=qn.height}else xi=yi,Ii=Pi,Ji=si=le.size(n,Xe);if($n=le.fill(n,Xe),Ki=le.stroke(n,Xe),Pe)Xe==Vs&&gs<=ze.prox&&(Fe=xi,Be=Ii,ot=Ji,Ct=si,Tt=ri,yt=$n,Ke=Ki);else{let qn=ct[Xe];qn!=null&&(Wt[Xe]=xi,Gn[Xe]=Ii,b0(qn,Ji,si,ri),x0(qn,$n,Ki),is(qn,Si(xi),Si(Ii),F,Ie))}}}}if(Pe){let Xe=ze.prox,Xt=dr==null?gs<=Xe:gs>Xe||Vs!=dr;if(pe||Xt){let sn=ct[0];sn!=null&&(Wt[0]=Fe,Gn[0]=Be,b0(sn,ot,Ct,Tt),x0(sn,yt,Ke),is(sn,Si(Fe),Si(Be),F,Ie))}}}if(qt.show&&Bs)if(v!=null){let[fe,be]=pn.scales,[Oe,Fe]=pn.match,[Be,ot]=v.cursor.sync.scales,Ct=v.cursor.drag;if(Rn=Ct._x,Pn=Ct._y,Rn||Pn){let{left:Tt,top:yt,width:Ke,height:Xe}=v.select,Xt=v.scales[Be].ori,sn=v.posToVal,Ln,Bt,rn,ii,Wn,yi=fe!=null&&Oe(fe,Be),Pi=be!=null&&Fe(be,ot);yi&&Rn?(Xt==0?(Ln=Tt,Bt=Ke):(Ln=yt,Bt=Xe),rn=b[fe],ii=W(sn(Ln,Be),rn,Y,0),Wn=W(sn(Ln+Bt,Be),rn,Y,0),na(Ui(ii,Wn),Sn(Wn-ii))):na(0,Y),Pi&&Pn?(Xt==1?(Ln=Tt,Bt=Ke):(Ln=yt,Bt=Xe),rn=b[be],ii=U(sn(Ln,ot),rn,oe,0),Wn=U(sn(Ln+Bt,ot),rn,oe,0),ia(Ui(ii,Wn),Sn(Wn-ii))):ia(0,oe)}else ud()}else{let fe=Sn(Cm-Tm),be=Sn(Rm-Am);if(D.ori==1){let ot=fe;fe=be,be=ot}Rn=Un.x&&fe>=Un.dist,Pn=Un.y&&be>=Un.dist;let Oe=Un.uni;Oe!=null?Rn&&Pn&&(Rn=fe>=Oe,Pn=be>=Oe,!Rn&&!Pn&&(be>fe?Pn=!0:Rn=!0)):Un.x&&Un.y&&(Rn||Pn)&&(Rn=Pn=!0);let Fe,Be;Rn&&(D.ori==0?(Fe=Xr,Be=$t):(Fe=Yr,Be=Jt),na(Ui(Fe,Be),Sn(Be-Fe)),Pn||ia(0,oe)),Pn&&(D.ori==1?(Fe=Xr,Be=$t):(Fe=Yr,Be=Jt),ia(Ui(Fe,Be),Sn(Be-Fe)),Rn||na(0,Y)),!Rn&&!Pn&&(na(0,0),ia(0,0))}if(Un._x=Rn,Un._y=Pn,v==null){if(P){if(Gm!=null){let[fe,be]=pn.scales;pn.values[0]=fe!=null?ji(D.ori==0?$t:Jt,fe):null,pn.values[1]=be!=null?ji(D.ori==1?$t:Jt,be):null}ra(Hd,n,$t,Jt,F,Ie,L)}if(tt){let fe=P&&pn.setSeries,be=ze.prox;dr==null?gs<=be&&Zi(Vs,jr,!0,fe):gs>be?Zi(null,jr,!0,fe):Vs!=dr&&Zi(Vs,jr,!0,fe)}}pe&&(de.idx=L,ld()),w!==!1&&In("setCursor")}let Gs=null;Object.defineProperty(n,"rect",{get(){return Gs==null&&sa(!1),Gs}});function sa(v=!1){v?Gs=null:(Gs=p.getBoundingClientRect(),In("syncRect",Gs))}function Lm(v,w,P,L,H,Y,oe){ue._lock||Bs&&v!=null&&v.movementX==0&&v.movementY==0||(cd(v,w,P,L,H,Y,oe,!1,v!=null),v!=null?fr(null,!0,!0):fr(w,!0,!1))}function cd(v,w,P,L,H,Y,oe,fe,be){if(Gs==null&&sa(!1),et(v),v!=null)P=v.clientX-Gs.left,L=v.clientY-Gs.top;else{if(P<0||L<0){$t=-10,Jt=-10;return}let[Oe,Fe]=pn.scales,Be=w.cursor.sync,[ot,Ct]=Be.values,[Tt,yt]=Be.scales,[Ke,Xe]=pn.match,Xt=w.axes[0].side%2==1,sn=D.ori==0?F:Ie,Ln=D.ori==1?F:Ie,Bt=Xt?Y:H,rn=Xt?H:Y,ii=Xt?L:P,Wn=Xt?P:L;if(Tt!=null?P=Ke(Oe,Tt)?a(ot,b[Oe],sn,0):-10:P=sn*(ii/Bt),yt!=null?L=Xe(Fe,yt)?a(Ct,b[Fe],Ln,0):-10:L=Ln*(Wn/rn),D.ori==1){let yi=P;P=L,L=yi}}be&&(w==null||w.cursor.event.type==Hd)&&((P<=1||P>=F-1)&&(P=Sr(P,F)),(L<=1||L>=Ie-1)&&(L=Sr(L,Ie))),fe?(Tm=P,Am=L,[Xr,Yr]=ue.move(n,P,L)):($t=P,Jt=L)}let hd={width:0,height:0,left:0,top:0};function ud(){Dl(hd,!1)}let Dm,Nm,Um,Om;function Fm(v,w,P,L,H,Y,oe){Bs=!0,Rn=Pn=Un._x=Un._y=!1,cd(v,w,P,L,H,Y,oe,!0,!1),v!=null&&(wt(Wd,Zd,km,!1),ra(d0,n,Xr,Yr,F,Ie,null));let{left:fe,top:be,width:Oe,height:Fe}=qt;Dm=fe,Nm=be,Um=Oe,Om=Fe}function km(v,w,P,L,H,Y,oe){Bs=Un._x=Un._y=!1,cd(v,w,P,L,H,Y,oe,!1,!0);let{left:fe,top:be,width:Oe,height:Fe}=qt,Be=Oe>0||Fe>0,ot=Dm!=fe||Nm!=be||Um!=Oe||Om!=Fe;if(Be&&ot&&Dl(qt),Un.setScale&&Be&&ot){let Ct=fe,Tt=Oe,yt=be,Ke=Fe;if(D.ori==1&&(Ct=be,Tt=Fe,yt=fe,Ke=Oe),Rn&&zs(A,ji(Ct,A),ji(Ct+Tt,A)),Pn)for(let Xe in b){let Xt=b[Xe];Xe!=A&&Xt.from==null&&Xt.min!=Vt&&zs(Xe,ji(yt+Ke,Xe),ji(yt,Xe))}ud()}else ue.lock&&(ue._lock=!ue._lock,fr(w,!0,v!=null));v!=null&&(yn(Wd,Zd),ra(Wd,n,$t,Jt,F,Ie,null))}function Kv(v,w,P,L,H,Y,oe){if(ue._lock)return;et(v);let fe=Bs;if(Bs){let be=!0,Oe=!0,Fe=10,Be,ot;D.ori==0?(Be=Rn,ot=Pn):(Be=Pn,ot=Rn),Be&&ot&&(be=$t<=Fe||$t>=F-Fe,Oe=Jt<=Fe||Jt>=Ie-Fe),Be&&be&&($t=$t<Xr?0:F),ot&&Oe&&(Jt=Jt<Yr?0:Ie),fr(null,!0,!0),Bs=!1}$t=-10,Jt=-10,ie.fill(null),fr(null,!0,!0),fe&&(Bs=fe)}function Bm(v,w,P,L,H,Y,oe){ue._lock||(et(v),ta(),ud(),v!=null&&ra(m0,n,$t,Jt,F,Ie,null))}function zm(){T.forEach(ew),O(n.width,n.height,!0)}Er(xc,ro,zm);let Jr={};Jr.mousedown=Fm,Jr.mousemove=Lm,Jr.mouseup=km,Jr.dblclick=Bm,Jr.setSeries=(v,w,P,L)=>{let H=pn.match[2];P=H(n,w,P),P!=-1&&Zi(P,L,!0,!1)},ge&&(wt(d0,p,Fm),wt(Hd,p,Lm),wt(f0,p,v=>{et(v),sa(!1)}),wt(p0,p,Kv),wt(m0,p,Bm),sf.add(n),n.syncRect=sa);let Nl=n.hooks=i.hooks||{};function In(v,w,P){Hn?Ft.push([v,w,P]):v in Nl&&Nl[v].forEach(L=>{L.call(null,n,w,P)})}(i.plugins||[]).forEach(v=>{for(let w in v.hooks)Nl[w]=(Nl[w]||[]).concat(v.hooks[w])});let Vm=(v,w,P)=>P,pn=mn({key:null,setSeries:!1,filters:{pub:T0,sub:T0},scales:[A,y[1]?y[1].scale:null],match:[A0,A0,Vm],values:[null,null]},ue.sync);pn.match.length==2&&pn.match.push(Vm),ue.sync=pn;let Gm=pn.key,dd=M_(Gm);function ra(v,w,P,L,H,Y,oe){pn.filters.pub(v,w,P,L,H,Y,oe)&&dd.pub(v,w,P,L,H,Y,oe)}dd.sub(n);function Qv(v,w,P,L,H,Y,oe){pn.filters.sub(v,w,P,L,H,Y,oe)&&Jr[v](null,w,P,L,H,Y,oe)}n.pub=Qv;function eb(){dd.unsub(n),sf.delete(n),Cn.clear(),Kd(xc,ro,zm),c.remove(),Re?.remove(),In("destroy")}n.destroy=eb;function fd(){In("init",i,e),ea(e||i.data,!1),G[A]?rd(A,G[A]):ta(),ne=qt.show&&(qt.width>0||qt.height>0),ee=pe=!0,O(i.width,i.height)}return y.forEach(Vr),T.forEach(ds),t?t instanceof HTMLElement?(t.appendChild(c),fd()):t(n,fd):fd(),n}On.assign=mn;On.fmtNum=uf;On.rangeNum=vc;On.rangeLog=Mc;On.rangeAsinh=cf;On.orient=Ar;On.pxRatio=Rt;On.join=$S;On.fmtDate=ff,On.tzDate=nM;On.sync=M_;{On.addGap=kM,On.clipGaps=Tc;let i=On.paths={points:R_};i.linear=I_,i.stepped=VM,i.bars=GM,i.spline=WM}var Pc=5,nw=7,iw=3,sw=4,rw={ArrowUp:1.01,ArrowDown:1/1.01,PageUp:1.1,PageDown:1/1.1},Ic=class{constructor(e,t){this.moves=t;this.layer=document.createElement("div");this.handles=new Map;this.sizes=new Map;this.before=new Map;this.plot=null;this.layer.className="limits",e.append(this.layer)}place(e,t,n){this.plot=e;let s=new Set(t.map(p=>p.id)),{left:r,top:o,width:a,height:l}=U_(e);for(let[p,_]of this.handles)s.has(p)||(_.remove(),this.handles.delete(p));Object.assign(this.layer.style,{left:`${r}px`,top:`${o}px`,width:`${a}px`,height:`${l}px`});let c=[...t].sort((p,_)=>p.y-_.y).flatMap(p=>{let _=this.handles.get(p.id)??this.made(p.id),m=this.put(_,p);return m?[{limit:p,handle:_,...m}]:[]}),h=p=>c.map(({limit:_,handle:m,...g})=>({...g,size:this.sizeOf(m,_[p],_.violated),before:this.before.get(`${_.id} ${p}`)})),u="label",d=h(u),f=Dd(d,{width:a,height:l},n,c.length>iw?1:2);return f.includes(null)&&(d=h(u="short"),f=Dd(d,{width:a,height:l},n,sw)),this.before=new Map(c.flatMap(({limit:p},_)=>f[_]?[[`${p.id} ${u}`,f[_].number]]:[])),c.forEach(({limit:p,handle:_},m)=>this.label(_,p[u],d[m],f[m])),f.flatMap(p=>p?[p.box]:[])}put(e,t){let n=this.plot,{width:s,height:r}=U_(n),o=m=>Math.min(Math.max(n.valToPos(m,"x"),0),s),a=o(t.from),l=Number.isFinite(t.to)?o(t.to):s,c=n.valToPos(t.y,"y"),h=n.valToPos(t.from,"x")<=s&&!(n.valToPos(t.to,"x")<0),u=!(h&&c>=0&&c<=r);if(e.hidden=u,u)return null;e.classList.toggle("violated",t.violated&&t.binding),e.classList.toggle("unbinding",t.violated&&!t.binding),e.classList.toggle("fixed",!t.movable);let d={"aria-label":`Limit of ${t.result}`,"aria-valuenow":String(t.y),"aria-valuetext":t.words,"aria-orientation":"vertical","aria-disabled":String(!t.movable),title:t.words};for(let[m,g]of Object.entries(d))e.setAttribute(m,g);Object.assign(e.style,{left:`${a}px`,width:`${Math.max(l-a,2*Pc)}px`,top:`${c-Pc}px`,height:`${2*Pc}px`});let{dash:[f=1,p=0]}=t,_=Math.min(nw/(f+p),1);for(let[m,g]of Object.entries({"--stroke":t.colour,"--on":`${_*f}px`,"--period":`${_*(f+p)}px`}))e.style.setProperty(m,g);return{left:a,right:l,top:c}}label(e,t,{left:n,right:s,top:r,size:o},a){let l=e.firstElementChild;l.textContent!==t&&(l.textContent=t),l.classList.toggle("unseen",!a);let[c,h]=a?.box??[Math.max(n,s-o),Math.max(r-15,0)];Object.assign(l.style,{left:`${c-n}px`,top:`${h-r+Pc}px`})}sizeOf(e,t,n){let s=`${n} ${t.replace(/\d/g,"0")}`,r=this.sizes.get(s);if(r!==void 0)return r;let o=e.firstElementChild;o.textContent=t,o.classList.remove("unseen");let a=o.offsetWidth;return a>0&&this.sizes.set(s,a),a}made(e){let t=document.createElement("div"),n=document.createElement("span");t.className="limit",t.tabIndex=0,t.setAttribute("role","slider"),t.append(n);let s=()=>t.classList.contains("fixed");return t.addEventListener("pointerdown",r=>{if(s()||r.button!==0)return;let o=r.clientY,a=this.plot.valToPos(Number(t.getAttribute("aria-valuenow")),"y"),l=c=>this.moves.moved(e,this.plot.posToVal(Math.min(Math.max(a+c.clientY-o,0),this.plot.over.clientHeight),"y"));t.setPointerCapture(r.pointerId),t.addEventListener("pointermove",l),t.addEventListener("lostpointercapture",()=>{t.removeEventListener("pointermove",l),this.moves.dropped(e)},{once:!0}),this.moves.began(),t.focus(),r.preventDefault()}),t.addEventListener("click",r=>r.stopPropagation()),t.addEventListener("keydown",r=>{let o=rw[r.key];!o||s()||r.ctrlKey||r.metaKey||(this.moves.stepped(e,o),r.preventDefault(),r.stopPropagation())}),this.layer.append(t),this.handles.set(e,t),t}};function U_({bbox:i}){let e=devicePixelRatio;return{left:i.left/e,top:i.top/e,width:i.width/e,height:i.height/e}}function F_(i,e=[]){let[t,n]=O_(i),s=n>0?[...e].filter(l=>l!==null&&l>=1e-5*n&&l<=n/1e-5):e,[r,o]=O_(s),a=Math.max(n,o);return a>0?[Math.max(Math.min(t,r),1e-5*(n||o))/1.3,a*2]:[1e-5,1]}function O_(i){let[e,t]=[1/0,0];for(let n of i)n!==null&&n>0&&Number.isFinite(n)&&([e,t]=[Math.min(e,n),Math.max(t,n)]);return[e,t]}function bf(i,e){if(!(i>0&&e>i&&Number.isFinite(e)))return{lines:[],labelled:[]};let t=vf(i,e,[1]),n=e/i<300||t.length<2?vf(i,e,[1,2,5]):t,s=n.length<3?ow(i,e):n;return{lines:e/i>1e8||n.length<3?s:vf(i,e,[1,2,3,4,5,6,7,8,9]),labelled:s}}function vf(i,e,t){let[n,s]=[Math.floor(Math.log10(i)),Math.ceil(Math.log10(e))],r=1+Math.floor((s-n)/12),o=[];for(let a=n;a<=s;a+=r)for(let l of t)o.push(+`${l}e${a}`);return o.filter(a=>a>=i*(1-1e-9)&&a<=e*(1+1e-9))}function ow(i,e){let t=(e-i)/5,n=10**Math.floor(Math.log10(t)),s=n*([1,2,5].find(a=>a*n>=t)??10),r=Math.ceil(i/s-1e-9),o=Math.floor((e-r*s)/s+1e-9);return Array.from({length:o+1},(a,l)=>Number(((r+l)*s).toPrecision(12)))}function k_(i,e,t){let n=[],s=[],r=()=>{s.length>1&&n.push(s),s=[]};for(let o=0;o<i.length;o++){let a=e[o]??null,l=o>0?e[o-1]??null:null,c=()=>i[o-1]+(i[o]-i[o-1])*(t-l)/(a-l);a!==null&&a>t?(!s.length&&l!==null&&s.push([c(),t]),s.push([i[o],a])):(s.length&&a!==null&&s.push([c(),t]),r())}return r(),n}var B_=1.6,Ta=class{constructor(e,t,n,s,r=null){this.parent=e;this.what=t;this.display=n;this.clicked=s;this.plot=null;this.picture=null;this.made="";this.held=null;this.handles=r&&new Ic(e,{...r,began:()=>{let{min:o,max:a}=this.plot.scales.y;this.held=[o,a],r.began()},dropped:o=>{this.held=null,r.dropped(o),this.rescale()}})}show(e){this.picture=e;let{display:t,what:n}=this,{theme:s,frequencyUnit:r,logarithmicFrequency:o,logarithmicAmplitude:a,decibel:l}=t,c=e.curves.map(d=>`${d.name} ${d.stroke}`),h=JSON.stringify([s,r,o,a,l,c,e.scale.unit]),u=[e.x,...e.curves.map(d=>n==="phase"?d.phase:d.amplitude)];h===this.made&&this.plot?this.plot.setData(u):(this.plot?.destroy(),this.plot=new On(this.options(),u,this.parent),this.made=h)}resize(){let{clientWidth:e,clientHeight:t}=this.parent;e>0&&t>0&&this.plot?.setSize({width:e,height:t})}rescale(){this.plot?.setData(this.plot.data)}redraw(){this.plot?.redraw(!1)}destroy(){this.plot?.destroy()}options(){let{display:e,what:t,picture:n}=this,s=ns(e.theme),r=t==="phase",o=!r&&e.logarithmicAmplitude&&!e.decibel,a={stroke:s.axis,grid:{stroke:s.grid,width:1},ticks:{stroke:s.grid,width:1},font:"11px system-ui, sans-serif",labelFont:"12px system-ui, sans-serif",labelSize:16},l=(u,d)=>d.map(f=>f===null?"":je(f,6)),c={splits:(u,d,f,p)=>bf(f,p).lines,filter:(u,d)=>d,values:(u,d,f)=>{let{min:p,max:_}=u.scales[u.axes[f].scale],{labelled:m}=bf(p,_);return d.map(g=>m.includes(g)?je(g,6):"")}},h=e.logarithmicFrequency?{distr:3,range:(u,d,f)=>[d,f]}:{distr:1};return{width:Math.max(this.parent.clientWidth,50),height:Math.max(this.parent.clientHeight,50),padding:[r?4:14,10,0,0],legend:{show:!1},cursor:{y:!1,drag:{x:!0,y:!1},points:{show:!1},lock:!1},scales:{x:{time:!1,...h},y:r?{range:[-190,190]}:{distr:o?3:1,range:(u,d,f)=>this.range(d,f,o)}},axes:[{...a,size:r?34:20,values:l,...e.logarithmicFrequency?c:{},...r?{label:`frequency [${e.frequencyUnit}]`}:{values:(u,d)=>d.map(()=>"")}},{...a,size:46,label:r?"phase [°]":e.decibel?`dB re 1 ${n.scale.unit}`:n.scale.unit,...o?c:{values:l},...r?{splits:()=>[-180,-90,0,90,180]}:{}}],series:[{},...n.curves.map(u=>{let{colour:d,dash:f}=ts(u.stroke,e.theme);return{label:u.name,stroke:d,dash:f,width:B_,points:{show:!1},spanGaps:!1,paths:z_(r?180:1/0)}})],hooks:{draw:[u=>this.marks(u)],ready:[u=>u.over.addEventListener("click",d=>this.clickedAt(u,d))]}}}range(e,t,n){if(this.held)return this.held;let{limits:s,overlays:r}=this.picture,o=r.flatMap(h=>h.points.map(u=>u[1])).filter(h=>h!==null),a=[...s.map(h=>h.y),...s.flatMap(h=>h.at?[h.at.y]:[]),...o];if(n)return F_([e,t],a);let l=a.reduce((h,u)=>Math.max(h,u),t??1),c=a.reduce((h,u)=>Math.min(h,u),e??0);return this.display.decibel?[Math.max(c,l-120)-3,l+6]:[0,l*1.12||1]}clickedAt(e,t){e.select.width>2||this.clicked(e.posToVal(t.offsetX,"x"))}marks(e){let{ctx:t,bbox:n}=e,s=this.picture,r=ns(this.display.theme),o=devicePixelRatio,a=h=>e.valToPos(h,"x",!0),l=h=>e.valToPos(h,"y",!0),c=(h,u,d,f)=>{h<e.scales.x.min||h>e.scales.x.max||Ea(t,u,d*o,f.map(p=>p*o),[[a(h),n.top],[a(h),n.top+n.height]])};t.save(),t.beginPath(),t.rect(n.left,n.top-14*o,n.width,n.height+14*o),t.clip();for(let h of s.natural)c(h,r.mode,1,[1,3]);if(this.what==="amplitude"){for(let u of s.overlays)this.overlay(t,u,d=>d.map(([f,p])=>[a(f),p===null?null:l(p)]));for(let u of s.limits)this.limit(e,u);let h=this.handles?.place(e,s.limits,this.curveFinder(e))??[];this.labels(e,r.text,h.map(([u,d,f,p])=>[n.left+u*o,n.top+d*o,n.left+f*o,n.top+p*o]))}s.cursor!==null&&c(s.cursor,r.text,1,[]),t.restore()}curveFinder(e){let{x:t,curves:n,limits:s}=this.picture,r=devicePixelRatio,{left:o,top:a}=e.bbox;if(!s.length)return()=>!1;let l=t.map(h=>e.valToPos(h,"x",!0)/r-o/r),c=n.map(h=>h.amplitude.map(u=>u===null?NaN:(e.valToPos(u,"y",!0)-a)/r));return([h,u,d,f])=>l.some((p,_)=>p>=h&&p<=d&&c.some(m=>m[_]>=u&&m[_]<=f))}limit(e,{result:t,from:n,to:s,y:r,isOfCurve:o,at:a,violated:l,binding:c}){let{ctx:h,bbox:u}=e,d=devicePixelRatio,f=ns(this.display.theme),{x:p,curves:_}=this.picture,m=c?f.violated:f.unbinding,g=x=>e.valToPos(x,"x",!0),y=e.valToPos(r,"y",!0),T=10*d,b=[Math.max(g(n),u.left),Number.isFinite(s)?Math.min(g(s),u.left+u.width):u.left+u.width];if(Ea(h,l?m:f.limit,1.6*d,b[1]-b[0]>3*T?[8*d,4*d]:[],[[b[0],y],[Math.max(b[1],b[0]+T),y]]),a){let[x,M]=[g(a.x),e.valToPos(a.y,"y",!0)];h.fillStyle=l?m:f.text,h.fillRect(x-3*d,M-3*d,6*d,6*d)}if(!o)return;let C=_.find(x=>x.name===t),A=p.map(x=>x>=n&&x<=s);for(let x of C?k_(p,C.amplitude.map((M,k)=>A[k]?M:null),r):[])this.exceeding(h,m,C.stroke,x.map(([M,k])=>[g(M),e.valToPos(k,"y",!0)]))}exceeding(e,t,n,s){let{colour:r,dash:o}=ts(n,this.display.theme),a=devicePixelRatio;Ea(e,t,4.6*a,[],s),Ea(e,r,B_*a,o.map(l=>l*a),s)}overlay(e,{stroke:t,kind:n,points:s,dash:r},o){let a=devicePixelRatio,{colour:l}=ts(t,this.display.theme),h=o(s).filter(u=>u[1]!==null);if(n==="violated"||n==="unbinding")return this.exceeding(e,ns(this.display.theme)[n],t,h);if(n==="measured")return lw(e,l,h,2*a);e.globalAlpha=n==="compared"?.7:1,Ea(e,l,(n==="stable"?2.6:1.3)*a,(r??{compared:[4,3],limit:[8,4],stable:[],unstable:[3,3],jump:[1,4]}[n]).map(u=>u*a),h),n==="jump"&&h.length===2&&aw(e,l,h[0],h[1],7*a),e.globalAlpha=1}labels(e,t,n){let{ctx:s,bbox:r}=e,o=devicePixelRatio,a=this.picture.curves.flatMap(({peaks:u,stroke:d})=>u.map(f=>({...f,stroke:d}))).sort((u,d)=>d.y-u.y),l=[...s0(this.picture.overlays),...a].slice(0,16);s.font=`${11*o}px system-ui, sans-serif`,s.textAlign="center";let c=l.map(u=>({...u,left:e.valToPos(u.x,"x",!0),top:e.valToPos(u.y,"y",!0)})).filter(u=>u.left>=r.left&&u.left<=r.left+r.width&&u.top>=r.top&&u.top<=r.top+r.height),h=4*o;for(let{left:u,top:d,stroke:f}of c)n.push([u-h,d-h,u+h,d+h]),s.fillStyle=ts(f,this.display.theme).colour,s.beginPath(),s.arc(u,d,2.6*o,0,7),s.fill();[s.fillStyle,s.strokeStyle,s.lineWidth,s.lineJoin]=[t,ns(this.display.theme).back,3*o,"round"];for(let{left:u,top:d,y:f}of c){let p=je(f,3),_=s.measureText(p).width/2,m=b=>{let C=Math.min(Math.max(b,r.left+_),r.left+r.width-_);return[C,[C-_-3,d-18*o,C+_+3,d-h]]},g=[u,u+_+h,u-_-h].map(m).find(([,b])=>!n.some(C=>no(C,b)));if(!g)continue;let[y,T]=g;n.push(T),s.strokeText(p,y,d-7*o),s.fillText(p,y,d-7*o)}}};function aw(i,e,[t,n],[s,r],o){let a=Math.atan2(r-n,s-t);i.fillStyle=e,i.beginPath(),i.moveTo(s,r);for(let l of[-.4,.4])i.lineTo(s-o*Math.cos(a+l),r-o*Math.sin(a+l));i.fill()}function lw(i,e,t,n){i.fillStyle=e;for(let[s,r]of t)i.beginPath(),i.arc(s,r,n,0,7),i.fill()}function Ea(i,e,t,n,s){i.strokeStyle=e,i.lineWidth=t,i.setLineDash(n),i.beginPath(),s.forEach(([r,o],a)=>a?i.lineTo(r,o):i.moveTo(r,o)),i.stroke(),i.setLineDash([])}var z_=i=>(e,t,n,s)=>{let r=new Path2D,o=e.data[0],a=e.data[t],l=null;for(let c=Math.max(n-1,0);c<=Math.min(s+1,o.length-1);c++){let h=a[c]??null;if(h!==null){let u=[e.valToPos(o[c],"x",!0),e.valToPos(h,"y",!0)];l===null||Math.abs(h-l)>i?r.moveTo(...u):r.lineTo(...u)}l=h}return{stroke:r,fill:null,clip:null,band:null,gaps:null,flags:0}};var Lc=class{constructor(){this.from=[];this.curves=null}of(e){let t=e.result("curves"),n=e.revisionOf("draft")>e.revisionOf("curves")?e.result("draft"):null;return this.from.length&&t===this.from[0]&&n===this.from[1]?this.curves:(this.from=[t,n],this.curves=n&&t&&cw(n,t)?hw(n,t):t,this.curves)}},cw=(i,e)=>i.results.every(({name:t,unit:n})=>e.results.some(s=>s.name===t&&s.unit===n));function hw(i,e){let t=e.results.map(o=>i.results.findIndex(a=>a.name===o.name)),n=i.results.length,s=i.models.map(o=>({...o,pieces:o.pieces.map(a=>({...a,values:o.delays.flatMap((l,c)=>t.map(h=>h<0?[]:a.values[c*n+h]))}))})),r=e.results.map(({extrema:o,...a})=>a);return{...i,draft:!0,results:r,models:s,limits:e.limits,lines:e.lines??[],vanishing:e.vanishing??[]}}var Dc=class{constructor(e,t,n){this.app=e;this.si=t;this.changed=n;this.values=new lc;this.known=new Map;this.pulled=null;this.began=()=>{};this.moved=(e,t)=>{let n=this.known.get(e),s=this.si(t);n&&s>0&&this.set(n.number,n.number.value*s/n.allowed,!0)};this.dropped=e=>{let t=this.known.get(e),{pulled:n}=this;this.pulled=null,t&&n?_a(this.app.state,t.number,n.value):this.app.state.dropped()};this.stepped=(e,t)=>{let n=this.known.get(e);n&&this.set(n.number,n.number.value*t,!1)}}get requirements(){return this.verdict?.requirements??[]}get areBinding(){return this.verdict?.decides!==!1}present(e){let{asker:t,state:n,index:s}=this.app,r=t.isOld("verdict"),o=this.areBinding;return this.known=new Map,e.map((a,l)=>{let{requirement:c}=a,h=c.place.join("."),u=cc(c.place,n.case,n.design,s);u&&this.pulled?.place===h&&(u.value=this.pulled.value);let d=u&&this.values.allowed(c,u,!r&&!this.pulled);return u&&d!==null&&this.app.engine.isLive&&this.known.set(`${l} ${h}`,{number:u,allowed:d}),{limit:a,allowed:d??c.allowed,written:u?`${je(u.value)} ${u.unit}`.trim():c.requirement,movable:d!==null&&this.app.engine.isLive,old:r,binding:o}})}get verdict(){let{asker:e,state:t}=this.app;return e.result("verdict")?.cases.find(n=>n.case===t.case)}set(e,t,n){let s=zg(t);!e.path&&n&&(this.pulled={place:uw(e),value:s}),_a(this.app.state,e,s,n),this.pulled&&this.changed()}},uw=({entry:{path:i}})=>(i[0]==="cases"?i.slice(2):i).join(".");var Sf=class extends vn{constructor(){super();this.amplitude=null;this.phase=null;this.picture=null;this.drawnCurves=new Lc;this.drawn=[];this.limitsDrawn="";this.notDrawn=[];this.compared=[];this.wanted="";this.hasBegun=!1;this.watcher=null;this.drawable=t=>t.results.filter(n=>n.unit===this.choice.unit&&!t.vanishing?.includes(n.name));this.asTable=!1,this.spoken="",this.kept=null,this.choice={model:0,unit:"",hidden:new Set}}static{this.properties={...vn.properties,asTable:{state:!0},choice:{state:!0},kept:{state:!0},spoken:{state:!0}}}render(){let{display:t,asker:n}=this.app,s=this.drawnCurves.of(n),r=s?pc(s):[],o=[this.wanted,this.choice.unit].find(c=>r.includes(c))??r[0]??"";s&&o!==this.choice.unit&&this.chooseUnit(s,o);let a=this.isFirstQuantityAwaited(r),l=(c,h,u)=>ae`<label title=${gw[c]??""}><input type="checkbox" .checked=${h}
      @change=${d=>u(d.target.checked)}> ${c}</label>`;return ae`
      <div class="bar">
        <h2 class="hidden">Characteristics</h2>${n.isOld("curves")||a?ae`<span class="old">…</span>`:Ue}
        ${r.length?ae`<select aria-label="Quantity" @change=${c=>this.chooseQuantity(s,c.target.value)}>
          ${(this.app.engine.isLive?V_(r):r).map(c=>ae`<option value=${c} ?selected=${c===o}>${Kr(c)}</option>`)}</select>`:Ue}
        ${s&&s.models.length>1?ae`<select aria-label="Excitation" @change=${c=>{this.choice={...this.choice,model:Number(c.target.value)}}}>
          ${s.models.map((c,h)=>ae`<option value=${h} ?selected=${h===this.choice.model}>${c.excitations?.join(", ")||"all excitations"}</option>`)}</select>`:Ue}
        <select aria-label="Unit of frequency" @change=${c=>t.set({frequencyUnit:c.target.value})}>
          ${Object.keys(Li).map(c=>ae`<option ?selected=${c===t.frequencyUnit}>${c}</option>`)}</select>
        ${l("log f",t.logarithmicFrequency,c=>t.set({logarithmicFrequency:c}))}
        ${l("log",t.logarithmicAmplitude,c=>t.set({logarithmicAmplitude:c}))}
        ${l("dB",t.decibel,c=>t.set({decibel:c}))}
        <details class="menu" @keydown=${dw}><summary title="draw others beside these curves">compare</summary><div>${l("keep these curves",this.kept!==null,c=>{this.kept=c?s:null})}${Cd(this.app).map(c=>l(Rd(c),Eg(this.app,c),h=>this.compare(c,h)))}</div></details>
        ${l("table",this.asTable,c=>{this.asTable=c})}
      </div>
      <div class="plots" tabindex="0" role="application" aria-label="Characteristics. Left and right arrow move the cursor, page up and page down go from peak to peak, Enter makes the machine swing at the cursor." @keydown=${this.key}>
        <div class="amplitude"></div><div class="phase"></div>
        ${s?Ue:ae`<p class="missing">${hc(this.app)}</p>`}
      </div>
      <div class="readings" role="group" aria-label="Curves">${this.legend(s)}</div>
      <p class="hidden" role="status" aria-live="polite">${this.spoken}</p>
      ${this.asTable&&this.picture?this.table(this.picture):Ue}`}connectedCallback(){super.connectedCallback(),this.unsubscribe.push(this.app.beside.subscribe(()=>this.requestUpdate()))}firstUpdated(){let t=r=>this.swing(r/Li[this.app.display.frequencyUnit]),[n,s]=[this.querySelector(".amplitude"),this.querySelector(".phase")];this.mover=new Dc(this.app,r=>a0(r,this.picture.scale,this.app.display),()=>this.requestUpdate()),this.amplitude=new Ta(n,"amplitude",this.app.display,t,this.mover),this.phase=new Ta(s,"phase",this.app.display,t);for(let r of[n,s])r.addEventListener("mousemove",o=>this.follow(o,r));this.watcher=new ResizeObserver(()=>{this.amplitude.resize(),this.phase.resize()}),this.watcher.observe(n),this.updated()}updated(){let{asker:t,display:n}=this.app,s=this.drawnCurves.of(t);if(!s||!this.amplitude)return;this.beginWithFirstLimit(s);let r=t.result("steady"),o=Ag(this.app,this.kept),a=this.mover.areBinding,l=[s,r,a,...o.flatMap(c=>[c.curves,c.measured?.[0],c.key]),this.choice,n.theme,n.frequencyUnit,n.logarithmicFrequency,n.decibel,n.logarithmicAmplitude];if(JSON.stringify(o.map(c=>[c.label,c.old,c.failure]))!==JSON.stringify(this.compared.map(c=>[c.label,c.old,c.failure]))&&this.requestUpdate(),this.compared=o,l.length!==this.drawn.length||l.some((c,h)=>c!==this.drawn[h]))this.drawn=l,this.picture=o0(s,this.choice,n,r,o,a),this.limitsDrawn=this.setLimits(s),n.drawn=this.picture.curves.map(c=>c.name),this.amplitude.show(this.picture),this.phase.show(this.picture),this.requestUpdate();else if(this.picture){let c=this.setLimits(s);c!==this.limitsDrawn&&(this.limitsDrawn=c,this.amplitude.rescale(),this.requestUpdate());let h=n.cursor===null?null:n.cursor*Li[n.frequencyUnit];if(h===this.picture.cursor)return;this.picture.cursor=h,this.amplitude.redraw(),this.phase.redraw()}}disconnectedCallback(){super.disconnectedCallback(),this.watcher?.disconnect(),this.amplitude?.destroy(),this.phase?.destroy()}setLimits(t){let{display:n}=this.app,{drawn:s,not:r}=Kg(t,this.choice.model,this.mover.requirements),o=this.drawable(t).map(a=>a.name);return this.notDrawn=r,this.picture.limits=l0(this.mover.present(s),o,this.choice.hidden,this.picture.scale,n),JSON.stringify([this.picture.limits,r.map(a=>a.why)])}legend(t){if(!t||!this.picture)return Ue;let n=this.picture.overlays.some(c=>c.kind==="stable"),s=n?"":this.steadyElsewhere(this.drawable(t)),{display:r}=this.app,o=this.drawable(t),a=this.indexAtCursor(),l=o[0]?.level;return ae`${a===null?Ue:ae`<span class="cursor">${je(this.picture.x[a],4)} ${r.frequencyUnit} [${this.unit}]</span>`}${this.notDrawn.length?ae`<details class="note"><summary>${this.notDrawn.length===1?"1 limit is":`${this.notDrawn.length} limits are`} not drawn</summary>
      <ul>${this.notDrawn.map(({words:c,why:h})=>ae`<li>${c}: ${h}</li>`)}</ul></details>`:Ue}${o.map((c,h)=>{let u=this.picture.curves.find(p=>p.name===c.name),{colour:d}=ts(h,r.theme),f=a!==null&&u?je(u.amplitude[a],3):"";return ae`<button class="curve" aria-pressed=${u!==void 0} @click=${()=>this.toggle(c.name)}>
        <svg viewBox="0 0 18 6" aria-hidden="true"><line x1="0" y1="3" x2="18" y2="3" stroke=${d} stroke-width="3" stroke-dasharray=${ts(h,r.theme).dash.join(" ")}></line></svg>
        ${c.name}${f?ae` <b>${f}</b>`:Ue}</button>`})}${this.compared.map(c=>ae`<span class="curve" title=${c.failure}><svg viewBox="0 0 26 6" aria-hidden="true">${c.measured?eo`<circle cx="7" cy="3" r="2.4" fill="currentColor"></circle><circle cx="18" cy="3" r="2.4" fill="currentColor"></circle>`:eo`<line x1="0" y1="3" x2="26" y2="3" stroke="currentColor" stroke-width="2" stroke-dasharray=${c.dash.join(" ")}></line>`}</svg> ${c.label}${c.failure?": not computed":""}${this.readings(c).map((h,u,d)=>ae`${u?", ":": "}${h.name}${h.at} <b>${h.value}</b>${u<d.length-1?Ue:` ${this.unit}`}`)}${c.old?ae` <span class="old">…</span>`:Ue}</span>`)}${n?ae`<span class="note">thick: steady motion of the nonlinear machine, half peak-to-peak${l&&l!=="0-p"?` at the level ${l} of a sine`:""}; dashed: unstable; arrow: jump</span>`:Ue}${s?ae`<span class="note">${s}</span>`:Ue}${this.notes()}`}notes(){let[t,...n]=this.app.asker.notes("curves");return ae`${t?ae`<span class="note">${t}</span>`:Ue}${n.length?ae`<details class="note"><summary>${n.length===1?"1 more note":`${n.length} more notes`}</summary>
      <ul>${n.map(s=>ae`<li>${s}</li>`)}</ul></details>`:Ue}`}steadyElsewhere(t){let n=this.app.asker.result("steady"),s=n?.over==="frequency"?n.results.find(r=>t.some(o=>o.name===r.name&&o.unit!==r.unit)):void 0;return s?`the steady motion is not drawn: it is computed as ${Kr(s.unit)}`:""}chooseUnit(t,n){let s=t.results.filter(l=>l.unit===n&&!t.vanishing?.includes(l.name)).map(l=>l.name),r=new Set([...this.app.index.byPath.values()].filter(l=>!l.children.length).flatMap(l=>l.path)),o=l=>r.has(l)?0:1,a=[...s].sort((l,c)=>o(l)-o(c));this.choice={...this.choice,unit:n,hidden:new Set(a.slice(fw))}}beginWithFirstLimit(t){let{asker:n}=this.app,s=n.result("verdict");if(this.wanted||this.hasBegun||!s)return;this.hasBegun=!0;let r=Qg(s,t);r!==null&&r!==this.choice.unit&&V_(pc(t)).includes(r)&&this.chooseQuantity(t,r)}isFirstQuantityAwaited(t){let{app:n}=this;return!n.engine.isLive||n.asker.failure("verdict")||n.asker.failure("curves")?!1:this.wanted?t.some(s=>mw(s,this.wanted))&&!t.includes(this.wanted):!this.hasBegun&&vi(n)&&!n.asker.problems.some(s=>s.severity==="error")}chooseQuantity(t,n){let{display:s,asker:r,beside:o}=this.app,a=Aa.findIndex(([l,c])=>l===n||c===n);if(this.wanted=n,pc(t).includes(n))return this.chooseUnit(t,n);s.set({quantity:pw[a]}),r.again(),o.rest()}compare(t,n){let{display:s,beside:r}=this.app;s.set({compared:new Map([...s.compared,[t,n]])}),r.rest()}toggle(t){let n=new Set(this.choice.hidden);n.delete(t)||n.add(t),this.choice={...this.choice,hidden:n}}indexAtCursor(){let{picture:t}=this;if(!t||t.cursor===null||!t.x.length)return null;let n=0;return t.x.forEach((s,r)=>{Math.abs(s-t.cursor)<Math.abs(t.x[n]-t.cursor)&&(n=r)}),n}follow(t,n){let s=n.querySelector(".u-over"),r=this.picture?.x;if(!s||!r?.length)return;let{left:o,width:a}=s.getBoundingClientRect(),l=(t.clientX-o)/a,[c,h]=[r[0],r.at(-1)];if(l<0||l>1)return;let u=this.app.display.logarithmicFrequency?c*(h/c)**l:c+l*(h-c);this.app.display.set({cursor:u/Li[this.app.display.frequencyUnit]})}swing(t){if(!this.app.engine.isLive)return this.app.display.set({cursor:t});this.app.display.set({shown:{kind:"frequency",omega:t},cursor:t}),this.app.asker.again()}key(t){let{display:n}=this.app,s=this.picture?.x,r=Li[n.frequencyUnit];if(!s?.length||t.ctrlKey||t.metaKey||t.altKey)return;let o=this.indexAtCursor()??0,a=[...new Set(this.picture.curves.flatMap(p=>p.peaks.map(_=>_.x)))].sort((p,_)=>p-_),l=t.shiftKey?.05:.004,c=this.picture.cursor??s[0],[h,u]=[s[0],s.at(-1)],d=p=>{let _=n.logarithmicFrequency?c*(u/h)**(p*l):c+p*l*(u-h);return Math.min(Math.max(_,h),u)},f={ArrowRight:d(1),ArrowLeft:d(-1),Home:h,End:u,PageDown:a.find(p=>p>c*(1+1e-9)),PageUp:a.findLast(p=>p<c*(1-1e-9))};if(t.key==="Enter")this.swing(s[o]/r);else if(t.key in f){let p=f[t.key];p!==void 0&&n.set({cursor:p/r}),this.updateComplete.then(()=>this.speak())}else return;t.preventDefault()}speak(){let t=this.indexAtCursor(),{picture:n}=this;if(t===null||!n)return;let s=[n.curves.map(r=>`${r.name} ${je(r.amplitude[t],3)} ${this.unit}`),...this.compared.map(r=>this.readings(r).map((o,a)=>`${a?"":`${r.label}: `}${o.name}${o.at} ${o.value} ${this.unit}`))];this.spoken=`${je(n.x[t],4)} ${this.app.display.frequencyUnit}: ${s.filter(r=>r.length).map(r=>r.join(", ")).join("; ")}`}get unit(){return this.app.display.decibel?"dB":this.picture.scale.unit}readings({key:t}){let{picture:n}=this,s=this.indexAtCursor();if(s===null||!n)return[];let r=a=>`${je(a,4)} ${this.app.display.frequencyUnit}`,o=r(n.x[s]);return n.overlays.filter(a=>a.of===t).flatMap(a=>{let l=n0(a,n.x[s]);return l?[{name:a.name,at:r(l.x)===o?"":` at ${r(l.x)}`,value:je(l.y,3)}]:[]})}table({x:t,curves:n}){let s=t.map((o,a)=>a).filter(o=>o%Math.ceil(t.length/60)===0),r=this.unit;return ae`<div class="scroll table" tabindex="0"><table><caption>Amplitudes [${r}]</caption><thead><tr><th scope="col">${this.app.display.frequencyUnit}</th>${n.map(o=>ae`<th scope="col">${o.name}</th>`)}</tr></thead>
      <tbody>${s.map(o=>ae`<tr><th scope="row">${je(t[o],4)}</th>${n.map(a=>ae`<td>${je(a.amplitude[o],3)}</td>`)}</tr>`)}</tbody></table></div>`}};function dw(i){let e=i.currentTarget;i.key!=="Escape"||!e.open||(e.open=!1,e.querySelector("summary").focus(),i.stopPropagation())}var fw=6,Aa=[["m","rad"],["m/s","rad/s"],["m/s²","rad/s²"]],pw=["displacement","velocity","acceleration"],mw=(i,e)=>[0,1].some(t=>[i,e].every(n=>Aa.some(s=>s[t]===n))),V_=i=>[...[0,1].flatMap(e=>i.some(t=>Aa.some(n=>n[e]===t))?Aa.map(t=>t[e]):[]),...i.filter(e=>!Aa.some(t=>t.includes(e)))],gw={"log f":"logarithmic frequency",log:"logarithmic amplitude",dB:"decibels of the SI unit","keep these curves":"dashed, to compare with changed ones",table:"the values as a table"};me.define("curve-chart",Sf);var ar={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},lr={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},Ey=0,sp=1,Ty=2;var _l=1,Ay=2,$o=3,cr=0,Kn=1,Ai=2,Ur=0,qo=1,rp=2,op=3,ap=4,Cy=5;var Or=100,Ry=101,Py=102,Iy=103,Ly=104,Dy=200,Ny=201,Uy=202,Oy=203,lp=204,cp=205,Fy=206,ky=207,By=208,zy=209,Vy=210,Gy=211,Hy=212,Wy=213,$y=214,uh=0,dh=1,fh=2,Do=3,ph=4,mh=5,gh=6,_h=7,Kh=0,qy=1,Xy=2,cs=0,hp=1,up=2,dp=3,fp=4,pp=5,mp=6,gp=7;var _p=300,Fr=301,Xo=302,Qh=303,eu=304,yh=1e3,os=1001,xh=1002,Nn=1003,Yy=1004;var yl=1005;var jn=1006,tu=1007;var Ls=1008;var ei=1009,yp=1010,xp=1011,Yo=1012,nu=1013,Gi=1014,Hi=1015,Wi=1016,iu=1017,su=1018,kr=1020,vp=35902,bp=35899,Sp=1021,Mp=1022,$i=1023,As=1026,Ds=1027,wp=1028,ru=1029,hr=1030,ou=1031;var au=1033,xl=33776,vl=33777,bl=33778,Sl=33779,lu=35840,cu=35841,hu=35842,uu=35843,du=36196,fu=37492,pu=37496,mu=37488,gu=37489,Ml=37490,_u=37491,yu=37808,xu=37809,vu=37810,bu=37811,Su=37812,Mu=37813,wu=37814,Eu=37815,Tu=37816,Au=37817,Cu=37818,Ru=37819,Pu=37820,Iu=37821,Lu=36492,Du=36494,Nu=36495,Uu=36283,Ou=36284,wl=36285,Fu=36286;var za=2300,vh=2301,ch=2302,jf=2303,Jf=2400,Kf=2401,Qf=2402;var Zy=3200;var El=0,jy=1,Ns="",di="srgb",Va="srgb-linear",Ga="linear",Dt="srgb";var hh=7680;var Jy=519,Ky=512,Qy=513,ex=514,Ep=515,tx=516,nx=517,Tp=518,Ap=519,Cp=35044;var Rp="300 es",wi=2e3,No=2001;function _w(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}function yw(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function Ha(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function ix(){let i=Ha("canvas");return i.style.display="block",i}var G_={},Uo=null;function Wa(...i){let e="THREE."+i.shift();Uo?Uo("log",e,...i):console.log(e,...i)}function sx(i){let e=i[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=i[1];t&&t.isStackTrace?i[0]+=" "+t.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function Ze(...i){i=sx(i);let e="THREE."+i.shift();if(Uo)Uo("warn",e,...i);else{let t=i[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...i)}}function Qe(...i){i=sx(i);let e="THREE."+i.shift();if(Uo)Uo("error",e,...i);else{let t=i[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...i)}}function Oa(...i){let e=i.join(" ");e in G_||(G_[e]=!0,Ze(...i))}function rx(i,e,t){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:n()}}setTimeout(r,t)})}var ox={[uh]:uh,[fh]:gh,[ph]:ph,[Do]:mh,[dh]:dh,[gh]:fh,[_h]:_h,[mh]:Do},Bi=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n===void 0?!1:n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let n=this._listeners;if(n===void 0)return;let s=n[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let n=t[e.type];if(n!==void 0){e.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},Bn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],H_=1234567,Io=Math.PI/180,Oo=180/Math.PI;function ur(){let i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(Bn[i&255]+Bn[i>>8&255]+Bn[i>>16&255]+Bn[i>>24&255]+"-"+Bn[e&255]+Bn[e>>8&255]+"-"+Bn[e>>16&15|64]+Bn[e>>24&255]+"-"+Bn[t&63|128]+Bn[t>>8&255]+"-"+Bn[t>>16&255]+Bn[t>>24&255]+Bn[n&255]+Bn[n>>8&255]+Bn[n>>16&255]+Bn[n>>24&255]).toLowerCase()}function ht(i,e,t){return Math.max(e,Math.min(t,i))}function Pp(i,e){return(i%e+e)%e}function xw(i,e,t,n,s){return n+(i-e)*(s-n)/(t-e)}function vw(i,e,t){return i!==e?(t-i)/(e-i):0}function Fa(i,e,t){return(1-t)*i+t*e}function bw(i,e,t,n){return Fa(i,e,1-Math.exp(-t*n))}function Sw(i,e=1){return e-Math.abs(Pp(i,e*2)-e)}function Mw(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*(3-2*i))}function ww(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*i*(i*(i*6-15)+10))}function Ew(i,e){return i+Math.floor(Math.random()*(e-i+1))}function Tw(i,e){return i+Math.random()*(e-i)}function Aw(i){return i*(.5-Math.random())}function Cw(i){i!==void 0&&(H_=i);let e=H_+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function Rw(i){return i*Io}function Pw(i){return i*Oo}function Iw(i){return i>0&&Number.isInteger(i)&&2**Math.round(Math.log2(i))===i}function Lw(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function Ip(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function Dw(i,e,t,n,s){let r=Math.cos,o=Math.sin,a=r(t/2),l=o(t/2),c=r((e+n)/2),h=o((e+n)/2),u=r((e-n)/2),d=o((e-n)/2),f=r((n-e)/2),p=o((n-e)/2);switch(s){case"XYX":i.set(a*h,l*u,l*d,a*c);break;case"YZY":i.set(l*d,a*h,l*u,a*c);break;case"ZXZ":i.set(l*u,l*d,a*h,a*c);break;case"XZX":i.set(a*h,l*p,l*f,a*c);break;case"YXY":i.set(l*f,a*h,l*p,a*c);break;case"ZYZ":i.set(l*p,l*f,a*h,a*c);break;default:Ze("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function ku(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Lp(i,e){if(e.constructor===Float32Array)return i;let t=ku(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/t,-1)}function Dp(i,e){if(e.constructor===Float32Array)return i;let t=ku(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*t)}var Np={DEG2RAD:Io,RAD2DEG:Oo,generateUUID:ur,clamp:ht,euclideanModulo:Pp,mapLinear:xw,inverseLerp:vw,lerp:Fa,damp:bw,pingpong:Sw,smoothstep:Mw,smootherstep:ww,randInt:Ew,randFloat:Tw,randFloatSpread:Aw,seededRandom:Cw,degToRad:Rw,radToDeg:Pw,isPowerOfTwo:Iw,ceilPowerOfTwo:Lw,floorPowerOfTwo:Ip,setQuaternionFromProperEuler:Dw,normalize:Dp,denormalize:Lp},Me=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,n=this.y,s=e.elements;return this.x=s[0]*t+s[3]*n+s[6],this.y=s[1]*t+s[4]*n+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=ht(this.x,e.x,t.x),this.y=ht(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=ht(this.x,e,t),this.y=ht(this.y,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ht(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(ht(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let n=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*n-o*s+e.x,this.y=r*s+o*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Mn=class{constructor(e=0,t=0,n=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=s}static slerpFlat(e,t,n,s,r,o,a){let l=n[s+0],c=n[s+1],h=n[s+2],u=n[s+3],d=r[o+0],f=r[o+1],p=r[o+2],_=r[o+3];if(u!==_||l!==d||c!==f||h!==p){let m=l*d+c*f+h*p+u*_;m<0&&(d=-d,f=-f,p=-p,_=-_,m=-m);let g=1-a;if(m<.9995){let y=Math.acos(m),T=Math.sin(y);g=Math.sin(g*y)/T,a=Math.sin(a*y)/T,l=l*g+d*a,c=c*g+f*a,h=h*g+p*a,u=u*g+_*a}else{l=l*g+d*a,c=c*g+f*a,h=h*g+p*a,u=u*g+_*a;let y=1/Math.sqrt(l*l+c*c+h*h+u*u);l*=y,c*=y,h*=y,u*=y}}e[t]=l,e[t+1]=c,e[t+2]=h,e[t+3]=u}static multiplyQuaternionsFlat(e,t,n,s,r,o){let a=n[s],l=n[s+1],c=n[s+2],h=n[s+3],u=r[o],d=r[o+1],f=r[o+2],p=r[o+3];return e[t]=a*p+h*u+l*f-c*d,e[t+1]=l*p+h*d+c*u-a*f,e[t+2]=c*p+h*f+a*d-l*u,e[t+3]=h*p-a*u-l*d-c*f,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,s){return this._x=e,this._y=t,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let n=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(n/2),h=a(s/2),u=a(r/2),d=l(n/2),f=l(s/2),p=l(r/2);switch(o){case"XYZ":this._x=d*h*u+c*f*p,this._y=c*f*u-d*h*p,this._z=c*h*p+d*f*u,this._w=c*h*u-d*f*p;break;case"YXZ":this._x=d*h*u+c*f*p,this._y=c*f*u-d*h*p,this._z=c*h*p-d*f*u,this._w=c*h*u+d*f*p;break;case"ZXY":this._x=d*h*u-c*f*p,this._y=c*f*u+d*h*p,this._z=c*h*p+d*f*u,this._w=c*h*u-d*f*p;break;case"ZYX":this._x=d*h*u-c*f*p,this._y=c*f*u+d*h*p,this._z=c*h*p-d*f*u,this._w=c*h*u+d*f*p;break;case"YZX":this._x=d*h*u+c*f*p,this._y=c*f*u+d*h*p,this._z=c*h*p-d*f*u,this._w=c*h*u-d*f*p;break;case"XZY":this._x=d*h*u-c*f*p,this._y=c*f*u-d*h*p,this._z=c*h*p+d*f*u,this._w=c*h*u+d*f*p;break;default:Ze("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let n=t/2,s=Math.sin(n);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,n=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],h=t[6],u=t[10],d=n+a+u;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(h-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(n>a&&n>u){let f=2*Math.sqrt(1+n-a-u);this._w=(h-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>u){let f=2*Math.sqrt(1+a-n-u);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+h)/f}else{let f=2*Math.sqrt(1+u-n-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+h)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<1e-8?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(ht(this.dot(e),-1,1)))}rotateTowards(e,t){let n=this.angleTo(e);if(n===0)return this;let s=Math.min(1,t/n);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,h=t._w;return this._x=n*h+o*a+s*c-r*l,this._y=s*h+o*l+r*a-n*c,this._z=r*h+o*c+n*l-s*a,this._w=o*h-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(n=-n,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),h=Math.sin(c);l=Math.sin(l*c)/h,t=Math.sin(t*c)/h,this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},I=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,n=0){this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(W_.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(W_.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*n+r[6]*s,this.y=r[1]*t+r[4]*n+r[7]*s,this.z=r[2]*t+r[5]*n+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,n=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*n),h=2*(a*t-r*s),u=2*(r*n-o*t);return this.x=t+l*c+o*u-a*h,this.y=n+l*h+a*c-r*u,this.z=s+l*u+r*h-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*n+r[8]*s,this.y=r[1]*t+r[5]*n+r[9]*s,this.z=r[2]*t+r[6]*n+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=ht(this.x,e.x,t.x),this.y=ht(this.y,e.y,t.y),this.z=ht(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=ht(this.x,e,t),this.y=ht(this.y,e,t),this.z=ht(this.z,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ht(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let n=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return Mf.copy(this).projectOnVector(e),this.sub(Mf)}reflect(e){return this.sub(Mf.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(ht(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y,s=this.z-e.z;return t*t+n*n+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){let s=Math.sin(t)*e;return this.x=s*Math.sin(n),this.y=Math.cos(t)*e,this.z=s*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Mf=new I,W_=new Mn,st=class{static{this.prototype.isMatrix3=!0}constructor(e,t,n,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c)}set(e,t,n,s,r,o,a,l,c){let h=this.elements;return h[0]=e,h[1]=s,h[2]=a,h[3]=t,h[4]=r,h[5]=l,h[6]=n,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],h=n[4],u=n[7],d=n[2],f=n[5],p=n[8],_=s[0],m=s[3],g=s[6],y=s[1],T=s[4],b=s[7],C=s[2],A=s[5],x=s[8];return r[0]=o*_+a*y+l*C,r[3]=o*m+a*T+l*A,r[6]=o*g+a*b+l*x,r[1]=c*_+h*y+u*C,r[4]=c*m+h*T+u*A,r[7]=c*g+h*b+u*x,r[2]=d*_+f*y+p*C,r[5]=d*m+f*T+p*A,r[8]=d*g+f*b+p*x,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8];return t*o*h-t*a*c-n*r*h+n*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],u=h*o-a*c,d=a*l-h*r,f=c*r-o*l,p=t*u+n*d+s*f;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let _=1/p;return e[0]=u*_,e[1]=(s*c-h*n)*_,e[2]=(a*n-s*o)*_,e[3]=d*_,e[4]=(h*t-s*l)*_,e[5]=(s*r-a*t)*_,e[6]=f*_,e[7]=(n*l-c*t)*_,e[8]=(o*t-n*r)*_,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return Oa("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(wf.makeScale(e,t)),this}rotate(e){return Oa("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(wf.makeRotation(-e)),this}translate(e,t){return Oa("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(wf.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<9;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}},wf=new st,$_=new st().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),q_=new st().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Nw(){let i={enabled:!0,workingColorSpace:Va,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Dt&&(s.r=Ts(s.r),s.g=Ts(s.g),s.b=Ts(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Dt&&(s.r=Lo(s.r),s.g=Lo(s.g),s.b=Lo(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Ns?Ga:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[Va]:{primaries:e,whitePoint:n,transfer:Ga,toXYZ:$_,fromXYZ:q_,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:di},outputColorSpaceConfig:{drawingBufferColorSpace:di}},[di]:{primaries:e,whitePoint:n,transfer:Dt,toXYZ:$_,fromXYZ:q_,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:di}}}),i}var bt=Nw();function Ts(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function Lo(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var po,bh=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let n;if(e instanceof HTMLCanvasElement)n=e;else{po===void 0&&(po=Ha("canvas")),po.width=e.width,po.height=e.height;let s=po.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),n=po}return n.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=Ha("canvas");t.width=e.width,t.height=e.height;let n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);let s=n.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Ts(r[o]/255)*255;return n.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let n=0;n<t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(Ts(t[n]/255)*255):t[n]=Ts(t[n]);return{data:t,width:e.width,height:e.height}}else return Ze("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},Uw=0,Fo=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:Uw++}),this.uuid=ur(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Ef(s[o].image)):r.push(Ef(s[o]))}else r=Ef(s);n.url=r}return t||(e.images[this.uuid]=n),n}};function Ef(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?bh.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(Ze("Texture: Unable to serialize Texture."),{})}var Ow=0,Tf=new I,Jn=class i extends Bi{constructor(e=i.DEFAULT_IMAGE,t=i.DEFAULT_MAPPING,n=os,s=os,r=jn,o=Ls,a=$i,l=ei,c=i.DEFAULT_ANISOTROPY,h=Ns){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Ow++}),this.uuid=ur(),this.name="",this.source=new Fo(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Me(0,0),this.repeat=new Me(1,1),this.center=new Me(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new st,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Tf).x}get height(){return this.source.getSize(Tf).y}get depth(){return this.source.getSize(Tf).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let n=e[t];if(n===void 0){Ze(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ze(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==_p)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case yh:e.x=e.x-Math.floor(e.x);break;case os:e.x=e.x<0?0:1;break;case xh:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case yh:e.y=e.y-Math.floor(e.y);break;case os:e.y=e.y<0?0:1;break;case xh:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};Jn.DEFAULT_IMAGE=null;Jn.DEFAULT_MAPPING=_p;Jn.DEFAULT_ANISOTROPY=1;var Kt=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,n=0,s=1){this.x=e,this.y=t,this.z=n,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,s){return this.x=e,this.y=t,this.z=n,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*n+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,s,r,l=e.elements,c=l[0],h=l[4],u=l[8],d=l[1],f=l[5],p=l[9],_=l[2],m=l[6],g=l[10];if(Math.abs(h-d)<.01&&Math.abs(u-_)<.01&&Math.abs(p-m)<.01){if(Math.abs(h+d)<.1&&Math.abs(u+_)<.1&&Math.abs(p+m)<.1&&Math.abs(c+f+g-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let T=(c+1)/2,b=(f+1)/2,C=(g+1)/2,A=(h+d)/4,x=(u+_)/4,M=(p+m)/4;return T>b&&T>C?T<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(T),s=A/n,r=x/n):b>C?b<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(b),n=A/s,r=M/s):C<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(C),n=x/r,s=M/r),this.set(n,s,r,t),this}let y=Math.sqrt((m-p)*(m-p)+(u-_)*(u-_)+(d-h)*(d-h));return Math.abs(y)<.001&&(y=1),this.x=(m-p)/y,this.y=(u-_)/y,this.z=(d-h)/y,this.w=Math.acos((c+f+g-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=ht(this.x,e.x,t.x),this.y=ht(this.y,e.y,t.y),this.z=ht(this.z,e.z,t.z),this.w=ht(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=ht(this.x,e,t),this.y=ht(this.y,e,t),this.z=ht(this.z,e,t),this.w=ht(this.w,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ht(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Sh=class extends Bi{constructor(e=1,t=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:jn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=n.depth,this.scissor=new Kt(0,0,e,t),this.scissorTest=!1,this.viewport=new Kt(0,0,e,t),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new Jn({width:e,height:t,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:jn,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,n=e.textures.length;t<n;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new Fo(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},mi=class extends Sh{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}},$a=class extends Jn{constructor(e=null,t=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=Nn,this.minFilter=Nn,this.wrapR=os,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var Mh=class extends Jn{constructor(e=null,t=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=Nn,this.minFilter=Nn,this.wrapR=os,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var St=class i{static{this.prototype.isMatrix4=!0}constructor(e,t,n,s,r,o,a,l,c,h,u,d,f,p,_,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c,h,u,d,f,p,_,m)}set(e,t,n,s,r,o,a,l,c,h,u,d,f,p,_,m){let g=this.elements;return g[0]=e,g[4]=t,g[8]=n,g[12]=s,g[1]=r,g[5]=o,g[9]=a,g[13]=l,g[2]=c,g[6]=h,g[10]=u,g[14]=d,g[3]=f,g[7]=p,g[11]=_,g[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){let t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),n.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,n=e.elements,s=1/mo.setFromMatrixColumn(e,0).length(),r=1/mo.setFromMatrixColumn(e,1).length(),o=1/mo.setFromMatrixColumn(e,2).length();return t[0]=n[0]*s,t[1]=n[1]*s,t[2]=n[2]*s,t[3]=0,t[4]=n[4]*r,t[5]=n[5]*r,t[6]=n[6]*r,t[7]=0,t[8]=n[8]*o,t[9]=n[9]*o,t[10]=n[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,n=e.x,s=e.y,r=e.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),u=Math.sin(r);if(e.order==="XYZ"){let d=o*h,f=o*u,p=a*h,_=a*u;t[0]=l*h,t[4]=-l*u,t[8]=c,t[1]=f+p*c,t[5]=d-_*c,t[9]=-a*l,t[2]=_-d*c,t[6]=p+f*c,t[10]=o*l}else if(e.order==="YXZ"){let d=l*h,f=l*u,p=c*h,_=c*u;t[0]=d+_*a,t[4]=p*a-f,t[8]=o*c,t[1]=o*u,t[5]=o*h,t[9]=-a,t[2]=f*a-p,t[6]=_+d*a,t[10]=o*l}else if(e.order==="ZXY"){let d=l*h,f=l*u,p=c*h,_=c*u;t[0]=d-_*a,t[4]=-o*u,t[8]=p+f*a,t[1]=f+p*a,t[5]=o*h,t[9]=_-d*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let d=o*h,f=o*u,p=a*h,_=a*u;t[0]=l*h,t[4]=p*c-f,t[8]=d*c+_,t[1]=l*u,t[5]=_*c+d,t[9]=f*c-p,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let d=o*l,f=o*c,p=a*l,_=a*c;t[0]=l*h,t[4]=_-d*u,t[8]=p*u+f,t[1]=u,t[5]=o*h,t[9]=-a*h,t[2]=-c*h,t[6]=f*u+p,t[10]=d-_*u}else if(e.order==="XZY"){let d=o*l,f=o*c,p=a*l,_=a*c;t[0]=l*h,t[4]=-u,t[8]=c*h,t[1]=d*u+_,t[5]=o*h,t[9]=f*u-p,t[2]=p*u-f,t[6]=a*h,t[10]=_*u+d}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(Fw,e,kw)}lookAt(e,t,n){let s=this.elements;return hi.subVectors(e,t),hi.lengthSq()===0&&(hi.z=1),hi.normalize(),Zs.crossVectors(n,hi),Zs.lengthSq()===0&&(Math.abs(n.z)===1?hi.x+=1e-4:hi.z+=1e-4,hi.normalize(),Zs.crossVectors(n,hi)),Zs.normalize(),Nc.crossVectors(hi,Zs),s[0]=Zs.x,s[4]=Nc.x,s[8]=hi.x,s[1]=Zs.y,s[5]=Nc.y,s[9]=hi.y,s[2]=Zs.z,s[6]=Nc.z,s[10]=hi.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],h=n[1],u=n[5],d=n[9],f=n[13],p=n[2],_=n[6],m=n[10],g=n[14],y=n[3],T=n[7],b=n[11],C=n[15],A=s[0],x=s[4],M=s[8],k=s[12],N=s[1],D=s[5],V=s[9],W=s[13],U=s[2],G=s[6],Z=s[10],z=s[14],ce=s[3],j=s[7],K=s[11],ie=s[15];return r[0]=o*A+a*N+l*U+c*ce,r[4]=o*x+a*D+l*G+c*j,r[8]=o*M+a*V+l*Z+c*K,r[12]=o*k+a*W+l*z+c*ie,r[1]=h*A+u*N+d*U+f*ce,r[5]=h*x+u*D+d*G+f*j,r[9]=h*M+u*V+d*Z+f*K,r[13]=h*k+u*W+d*z+f*ie,r[2]=p*A+_*N+m*U+g*ce,r[6]=p*x+_*D+m*G+g*j,r[10]=p*M+_*V+m*Z+g*K,r[14]=p*k+_*W+m*z+g*ie,r[3]=y*A+T*N+b*U+C*ce,r[7]=y*x+T*D+b*G+C*j,r[11]=y*M+T*V+b*Z+C*K,r[15]=y*k+T*W+b*z+C*ie,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],h=e[2],u=e[6],d=e[10],f=e[14],p=e[3],_=e[7],m=e[11],g=e[15],y=l*f-c*d,T=a*f-c*u,b=a*d-l*u,C=o*f-c*h,A=o*d-l*h,x=o*u-a*h;return t*(_*y-m*T+g*b)-n*(p*y-m*C+g*A)+s*(p*T-_*C+g*x)-r*(p*b-_*A+m*x)}determinantAffine(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],h=e[10];return t*(o*h-a*c)-n*(r*h-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=n),this}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],u=e[9],d=e[10],f=e[11],p=e[12],_=e[13],m=e[14],g=e[15],y=t*a-n*o,T=t*l-s*o,b=t*c-r*o,C=n*l-s*a,A=n*c-r*a,x=s*c-r*l,M=h*_-u*p,k=h*m-d*p,N=h*g-f*p,D=u*m-d*_,V=u*g-f*_,W=d*g-f*m,U=y*W-T*V+b*D+C*N-A*k+x*M;if(U===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let G=1/U;return e[0]=(a*W-l*V+c*D)*G,e[1]=(s*V-n*W-r*D)*G,e[2]=(_*x-m*A+g*C)*G,e[3]=(d*A-u*x-f*C)*G,e[4]=(l*N-o*W-c*k)*G,e[5]=(t*W-s*N+r*k)*G,e[6]=(m*b-p*x-g*T)*G,e[7]=(h*x-d*b+f*T)*G,e[8]=(o*V-a*N+c*M)*G,e[9]=(n*N-t*V-r*M)*G,e[10]=(p*A-_*b+g*y)*G,e[11]=(u*b-h*A-f*y)*G,e[12]=(a*k-o*D-l*M)*G,e[13]=(t*D-n*k+s*M)*G,e[14]=(_*T-p*C-m*y)*G,e[15]=(h*C-u*T+d*y)*G,this}scale(e){let t=this.elements,n=e.x,s=e.y,r=e.z;return t[0]*=n,t[4]*=s,t[8]*=r,t[1]*=n,t[5]*=s,t[9]*=r,t[2]*=n,t[6]*=s,t[10]*=r,t[3]*=n,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,s))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let n=Math.cos(t),s=Math.sin(t),r=1-n,o=e.x,a=e.y,l=e.z,c=r*o,h=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+n,h*l-s*o,0,c*l-s*a,h*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,s,r,o){return this.set(1,n,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,n){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,h=o+o,u=a+a,d=r*c,f=r*h,p=r*u,_=o*h,m=o*u,g=a*u,y=l*c,T=l*h,b=l*u,C=n.x,A=n.y,x=n.z;return s[0]=(1-(_+g))*C,s[1]=(f+b)*C,s[2]=(p-T)*C,s[3]=0,s[4]=(f-b)*A,s[5]=(1-(d+g))*A,s[6]=(m+y)*A,s[7]=0,s[8]=(p+T)*x,s[9]=(m-y)*x,s[10]=(1-(d+_))*x,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,n){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),t.identity(),this;let o=mo.set(s[0],s[1],s[2]).length(),a=mo.set(s[4],s[5],s[6]).length(),l=mo.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Oi.copy(this);let c=1/o,h=1/a,u=1/l;return Oi.elements[0]*=c,Oi.elements[1]*=c,Oi.elements[2]*=c,Oi.elements[4]*=h,Oi.elements[5]*=h,Oi.elements[6]*=h,Oi.elements[8]*=u,Oi.elements[9]*=u,Oi.elements[10]*=u,t.setFromRotationMatrix(Oi),n.x=o,n.y=a,n.z=l,this}makePerspective(e,t,n,s,r,o,a=wi,l=!1){let c=this.elements,h=2*r/(t-e),u=2*r/(n-s),d=(t+e)/(t-e),f=(n+s)/(n-s),p,_;if(l)p=r/(o-r),_=o*r/(o-r);else if(a===wi)p=-(o+r)/(o-r),_=-2*o*r/(o-r);else if(a===No)p=-o/(o-r),_=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=u,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=p,c[14]=_,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,n,s,r,o,a=wi,l=!1){let c=this.elements,h=2/(t-e),u=2/(n-s),d=-(t+e)/(t-e),f=-(n+s)/(n-s),p,_;if(l)p=1/(o-r),_=o/(o-r);else if(a===wi)p=-2/(o-r),_=-(o+r)/(o-r);else if(a===No)p=-1/(o-r),_=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=u,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=p,c[14]=_,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<16;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}},mo=new I,Oi=new St,Fw=new I(0,0,0),kw=new I(1,1,1),Zs=new I,Nc=new I,hi=new I,X_=new St,Y_=new Mn,as=class i{constructor(e=0,t=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=n,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,s=this._order){return this._x=e,this._y=t,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],h=s[9],u=s[2],d=s[6],f=s[10];switch(t){case"XYZ":this._y=Math.asin(ht(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-ht(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(ht(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-u,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-ht(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(ht(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-ht(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,f),this._y=0);break;default:Ze("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return X_.makeRotationFromQuaternion(e),this.setFromRotationMatrix(X_,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return Y_.setFromEuler(this),this.setFromQuaternion(Y_,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};as.DEFAULT_ORDER="XYZ";var ko=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},Bw=0,Z_=new I,go=new Mn,bs=new St,Uc=new I,Ca=new I,zw=new I,Vw=new Mn,j_=new I(1,0,0),J_=new I(0,1,0),K_=new I(0,0,1),Q_={type:"added"},Gw={type:"removed"},_o={type:"childadded",child:null},Af={type:"childremoved",child:null},wn=class i extends Bi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Bw++}),this.uuid=ur(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let e=new I,t=new as,n=new Mn,s=new I(1,1,1);function r(){n.setFromEuler(t,!1)}function o(){t.setFromQuaternion(n,void 0,!1)}t._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new St},normalMatrix:{value:new st}}),this.matrix=new St,this.matrixWorld=new St,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new ko,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return go.setFromAxisAngle(e,t),this.quaternion.multiply(go),this}rotateOnWorldAxis(e,t){return go.setFromAxisAngle(e,t),this.quaternion.premultiply(go),this}rotateX(e){return this.rotateOnAxis(j_,e)}rotateY(e){return this.rotateOnAxis(J_,e)}rotateZ(e){return this.rotateOnAxis(K_,e)}translateOnAxis(e,t){return Z_.copy(e).applyQuaternion(this.quaternion),this.position.add(Z_.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(j_,e)}translateY(e){return this.translateOnAxis(J_,e)}translateZ(e){return this.translateOnAxis(K_,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(bs.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?Uc.copy(e):Uc.set(e,t,n);let s=this.parent;this.updateWorldMatrix(!0,!1),Ca.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?bs.lookAt(Ca,Uc,this.up):bs.lookAt(Uc,Ca,this.up),this.quaternion.setFromRotationMatrix(bs),s&&(bs.extractRotation(s.matrixWorld),go.setFromRotationMatrix(bs),this.quaternion.premultiply(go.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(Qe("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(Q_),_o.child=e,this.dispatchEvent(_o),_o.child=null):Qe("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(Gw),Af.child=e,this.dispatchEvent(Af),Af.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),bs.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),bs.multiply(e.parent.matrixWorld)),e.applyMatrix4(bs),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(Q_),_o.child=e,this.dispatchEvent(_o),_o.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ca,e,zw),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ca,Vw,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,n=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*n-r[8]*s,r[13]+=n-r[1]*t-r[5]*n-r[9]*s,r[14]+=s-r[2]*t-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t,n=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,n)}}toJSON(e){let t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let u=l[c];r(e.shapes,u)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),h=o(e.images),u=o(e.shapes),d=o(e.skeletons),f=o(e.animations),p=o(e.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),h.length>0&&(n.images=h),u.length>0&&(n.shapes=u),d.length>0&&(n.skeletons=d),f.length>0&&(n.animations=f),p.length>0&&(n.nodes=p)}return n.object=s,n;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){let s=e.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};wn.DEFAULT_UP=new I(0,1,0);wn.DEFAULT_MATRIX_AUTO_UPDATE=!0;wn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Pt=class extends wn{constructor(){super(),this.isGroup=!0,this.type="Group"}},Hw={type:"move"},Bo=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Pt,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Pt,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new I,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new I),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Pt,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new I,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new I,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let _ of e.hand.values()){let m=t.getJointPose(_,n),g=this._getHandJoint(c,_);m!==null&&(g.matrix.fromArray(m.transform.matrix),g.matrix.decompose(g.position,g.quaternion,g.scale),g.matrixWorldNeedsUpdate=!0,g.jointRadius=m.radius),g.visible=m!==null}let h=c.joints["index-finger-tip"],u=c.joints["thumb-tip"],d=h.position.distanceTo(u.position),f=.02,p=.005;c.inputState.pinching&&d>f+p?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&d<=f-p&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(Hw)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let n=new Pt;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}},ax={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},js={h:0,s:0,l:0},Oc={h:0,s:0,l:0};function Cf(i,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}var it=class{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=di){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,bt.colorSpaceToWorking(this,t),this}setRGB(e,t,n,s=bt.workingColorSpace){return this.r=e,this.g=t,this.b=n,bt.colorSpaceToWorking(this,s),this}setHSL(e,t,n,s=bt.workingColorSpace){if(e=Pp(e,1),t=ht(t,0,1),n=ht(n,0,1),t===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+t):n+t-n*t,o=2*n-r;this.r=Cf(o,r,e+1/3),this.g=Cf(o,r,e),this.b=Cf(o,r,e-1/3)}return bt.colorSpaceToWorking(this,s),this}setStyle(e,t=di){function n(r){r!==void 0&&parseFloat(r)<1&&Ze("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:Ze("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);Ze("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=di){let n=ax[e.toLowerCase()];return n!==void 0?this.setHex(n,t):Ze("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Ts(e.r),this.g=Ts(e.g),this.b=Ts(e.b),this}copyLinearToSRGB(e){return this.r=Lo(e.r),this.g=Lo(e.g),this.b=Lo(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=di){return bt.workingToColorSpace(zn.copy(this),e),Math.round(ht(zn.r*255,0,255))*65536+Math.round(ht(zn.g*255,0,255))*256+Math.round(ht(zn.b*255,0,255))}getHexString(e=di){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=bt.workingColorSpace){bt.workingToColorSpace(zn.copy(this),t);let n=zn.r,s=zn.g,r=zn.b,o=Math.max(n,s,r),a=Math.min(n,s,r),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let u=o-a;switch(c=h<=.5?u/(o+a):u/(2-o-a),o){case n:l=(s-r)/u+(s<r?6:0);break;case s:l=(r-n)/u+2;break;case r:l=(n-s)/u+4;break}l/=6}return e.h=l,e.s=c,e.l=h,e}getRGB(e,t=bt.workingColorSpace){return bt.workingToColorSpace(zn.copy(this),t),e.r=zn.r,e.g=zn.g,e.b=zn.b,e}getStyle(e=di){bt.workingToColorSpace(zn.copy(this),e);let t=zn.r,n=zn.g,s=zn.b;return e!==di?`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(e,t,n){return this.getHSL(js),this.setHSL(js.h+e,js.s+t,js.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(js),e.getHSL(Oc);let n=Fa(js.h,Oc.h,t),s=Fa(js.s,Oc.s,t),r=Fa(js.l,Oc.l,t);return this.setHSL(n,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,n=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*n+r[6]*s,this.g=r[1]*t+r[4]*n+r[7]*s,this.b=r[2]*t+r[5]*n+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},zn=new it;it.NAMES=ax;var zo=class extends wn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new as,this.environmentIntensity=1,this.environmentRotation=new as,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},Fi=new I,Ss=new I,Rf=new I,Ms=new I,yo=new I,xo=new I,ey=new I,Pf=new I,If=new I,Lf=new I,Df=new Kt,Nf=new Kt,Uf=new Kt,rs=class i{constructor(e=new I,t=new I,n=new I){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,s){s.subVectors(n,t),Fi.subVectors(e,t),s.cross(Fi);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,n,s,r){Fi.subVectors(s,t),Ss.subVectors(n,t),Rf.subVectors(e,t);let o=Fi.dot(Fi),a=Fi.dot(Ss),l=Fi.dot(Rf),c=Ss.dot(Ss),h=Ss.dot(Rf),u=o*c-a*a;if(u===0)return r.set(0,0,0),null;let d=1/u,f=(c*l-a*h)*d,p=(o*h-a*l)*d;return r.set(1-f-p,p,f)}static containsPoint(e,t,n,s){return this.getBarycoord(e,t,n,s,Ms)===null?!1:Ms.x>=0&&Ms.y>=0&&Ms.x+Ms.y<=1}static getInterpolation(e,t,n,s,r,o,a,l){return this.getBarycoord(e,t,n,s,Ms)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Ms.x),l.addScaledVector(o,Ms.y),l.addScaledVector(a,Ms.z),l)}static getInterpolatedAttribute(e,t,n,s,r,o){return Df.setScalar(0),Nf.setScalar(0),Uf.setScalar(0),Df.fromBufferAttribute(e,t),Nf.fromBufferAttribute(e,n),Uf.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(Df,r.x),o.addScaledVector(Nf,r.y),o.addScaledVector(Uf,r.z),o}static isFrontFacing(e,t,n,s){return Fi.subVectors(n,t),Ss.subVectors(e,t),Fi.cross(Ss).dot(s)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,s){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,n,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Fi.subVectors(this.c,this.b),Ss.subVectors(this.a,this.b),Fi.cross(Ss).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return i.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return i.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,s,r){return i.getInterpolation(e,this.a,this.b,this.c,t,n,s,r)}containsPoint(e){return i.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return i.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let n=this.a,s=this.b,r=this.c,o,a;yo.subVectors(s,n),xo.subVectors(r,n),Pf.subVectors(e,n);let l=yo.dot(Pf),c=xo.dot(Pf);if(l<=0&&c<=0)return t.copy(n);If.subVectors(e,s);let h=yo.dot(If),u=xo.dot(If);if(h>=0&&u<=h)return t.copy(s);let d=l*u-h*c;if(d<=0&&l>=0&&h<=0&&l-h>0)return o=l/(l-h),t.copy(n).addScaledVector(yo,o);Lf.subVectors(e,r);let f=yo.dot(Lf),p=xo.dot(Lf);if(p>=0&&f<=p)return t.copy(r);let _=f*c-l*p;if(_<=0&&c>=0&&p<=0)return a=c/(c-p),t.copy(n).addScaledVector(xo,a);let m=h*p-f*u;if(m<=0&&u-h>=0&&f-p>=0)return ey.subVectors(r,s),a=(u-h)/(u-h+(f-p)),t.copy(s).addScaledVector(ey,a);let g=1/(m+_+d);return o=_*g,a=d*g,t.copy(n).addScaledVector(yo,o).addScaledVector(xo,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},Ei=class{constructor(e=new I(1/0,1/0,1/0),t=new I(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint(ki.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint(ki.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=ki.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let n=e.geometry;if(n!==void 0){let r=n.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,ki):ki.fromBufferAttribute(r,o),ki.applyMatrix4(e.matrixWorld),this.expandByPoint(ki);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Fc.copy(e.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),Fc.copy(n.boundingBox)),Fc.applyMatrix4(e.matrixWorld),this.union(Fc)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,ki),ki.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(Ra),kc.subVectors(this.max,Ra),vo.subVectors(e.a,Ra),bo.subVectors(e.b,Ra),So.subVectors(e.c,Ra),Js.subVectors(bo,vo),Ks.subVectors(So,bo),Cr.subVectors(vo,So);let t=[0,-Js.z,Js.y,0,-Ks.z,Ks.y,0,-Cr.z,Cr.y,Js.z,0,-Js.x,Ks.z,0,-Ks.x,Cr.z,0,-Cr.x,-Js.y,Js.x,0,-Ks.y,Ks.x,0,-Cr.y,Cr.x,0];return!Of(t,vo,bo,So,kc)||(t=[1,0,0,0,1,0,0,0,1],!Of(t,vo,bo,So,kc))?!1:(Bc.crossVectors(Js,Ks),t=[Bc.x,Bc.y,Bc.z],Of(t,vo,bo,So,kc))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,ki).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(ki).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(ws[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),ws[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),ws[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),ws[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),ws[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),ws[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),ws[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),ws[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(ws),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},ws=[new I,new I,new I,new I,new I,new I,new I,new I],ki=new I,Fc=new Ei,vo=new I,bo=new I,So=new I,Js=new I,Ks=new I,Cr=new I,Ra=new I,kc=new I,Bc=new I,Rr=new I;function Of(i,e,t,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){Rr.fromArray(i,r);let a=s.x*Math.abs(Rr.x)+s.y*Math.abs(Rr.y)+s.z*Math.abs(Rr.z),l=e.dot(Rr),c=t.dot(Rr),h=n.dot(Rr);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var gn=new I,zc=new Me,Ww=0,pi=class extends Bi{constructor(e,t,n=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Ww++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=n,this.usage=Cp,this.updateRanges=[],this.gpuType=Hi,this.version=0,this._normalizationScale=e!==void 0?ku(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[n+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)zc.fromBufferAttribute(this,t),zc.applyMatrix3(e),this.setXY(t,zc.x,zc.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)gn.fromBufferAttribute(this,t),gn.applyMatrix3(e),this.setXYZ(t,gn.x,gn.y,gn.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)gn.fromBufferAttribute(this,t),gn.applyMatrix4(e),this.setXYZ(t,gn.x,gn.y,gn.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)gn.fromBufferAttribute(this,t),gn.applyNormalMatrix(e),this.setXYZ(t,gn.x,gn.y,gn.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)gn.fromBufferAttribute(this,t),gn.transformDirection(e),this.setXYZ(t,gn.x,gn.y,gn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Lp(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Dp(e,this.array)}};var qa=class extends pi{constructor(e,t,n){super(new Uint16Array(e),t,n)}};var Xa=class extends pi{constructor(e,t,n){super(new Uint32Array(e),t,n)}};var ut=class extends pi{constructor(e,t,n){super(new Float32Array(e),t,n)}},$w=new Ei,Pa=new I,Ff=new I,Cs=class{constructor(e=new I,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let n=this.center;t!==void 0?n.copy(t):$w.setFromPoints(e).getCenter(n);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,n.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;Pa.subVectors(e,this.center);let t=Pa.lengthSq();if(t>this.radius*this.radius){let n=Math.sqrt(t),s=(n-this.radius)*.5;this.center.addScaledVector(Pa,s/n),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Ff.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(Pa.copy(e.center).add(Ff)),this.expandByPoint(Pa.copy(e.center).sub(Ff))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},qw=0,Mi=new St,kf=new wn,Mo=new I,ui=new Ei,Ia=new Ei,Dn=new I,Nt=class i extends Bi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:qw++}),this.uuid=ur(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(_w(e)?Xa:qa)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new st().getNormalMatrix(e);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Mi.makeRotationFromQuaternion(e),this.applyMatrix4(Mi),this}rotateX(e){return Mi.makeRotationX(e),this.applyMatrix4(Mi),this}rotateY(e){return Mi.makeRotationY(e),this.applyMatrix4(Mi),this}rotateZ(e){return Mi.makeRotationZ(e),this.applyMatrix4(Mi),this}translate(e,t,n){return Mi.makeTranslation(e,t,n),this.applyMatrix4(Mi),this}scale(e,t,n){return Mi.makeScale(e,t,n),this.applyMatrix4(Mi),this}lookAt(e){return kf.lookAt(e),kf.updateMatrix(),this.applyMatrix4(kf.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Mo).negate(),this.translate(Mo.x,Mo.y,Mo.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let n=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new ut(n,3))}else{let n=Math.min(e.length,t.count);for(let s=0;s<n;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&Ze("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Ei);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){Qe("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new I(-1/0,-1/0,-1/0),new I(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,s=t.length;n<s;n++){let r=t[n];ui.setFromBufferAttribute(r),this.morphTargetsRelative?(Dn.addVectors(this.boundingBox.min,ui.min),this.boundingBox.expandByPoint(Dn),Dn.addVectors(this.boundingBox.max,ui.max),this.boundingBox.expandByPoint(Dn)):(this.boundingBox.expandByPoint(ui.min),this.boundingBox.expandByPoint(ui.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&Qe('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Cs);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){Qe("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new I,1/0);return}if(e){let n=this.boundingSphere.center;if(ui.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];Ia.setFromBufferAttribute(a),this.morphTargetsRelative?(Dn.addVectors(ui.min,Ia.min),ui.expandByPoint(Dn),Dn.addVectors(ui.max,Ia.max),ui.expandByPoint(Dn)):(ui.expandByPoint(Ia.min),ui.expandByPoint(Ia.max))}ui.getCenter(n);let s=0;for(let r=0,o=e.count;r<o;r++)Dn.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(Dn));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)Dn.fromBufferAttribute(a,c),l&&(Mo.fromBufferAttribute(e,c),Dn.add(Mo)),s=Math.max(s,n.distanceToSquared(Dn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&Qe('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){Qe("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new pi(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(n.count);for(let k=0;k<n.count;k++)a[k]=new I,l[k]=new I;let h=new I,u=new I,d=new I,f=new Me,p=new Me,_=new Me,m=new I,g=new I;function y(k,N,D){c[k]=c[N]=c[D]=1,h.fromBufferAttribute(n,k),u.fromBufferAttribute(n,N),d.fromBufferAttribute(n,D),f.fromBufferAttribute(r,k),p.fromBufferAttribute(r,N),_.fromBufferAttribute(r,D),u.sub(h),d.sub(h),p.sub(f),_.sub(f);let V=1/(p.x*_.y-_.x*p.y);isFinite(V)&&(m.copy(u).multiplyScalar(_.y).addScaledVector(d,-p.y).multiplyScalar(V),g.copy(d).multiplyScalar(p.x).addScaledVector(u,-_.x).multiplyScalar(V),a[k].add(m),a[N].add(m),a[D].add(m),l[k].add(g),l[N].add(g),l[D].add(g))}let T=this.groups;T.length===0&&(T=[{start:0,count:e.count}]);for(let k=0,N=T.length;k<N;++k){let D=T[k],V=D.start,W=D.count;for(let U=V,G=V+W;U<G;U+=3)y(e.getX(U+0),e.getX(U+1),e.getX(U+2))}let b=new I,C=new I,A=new I,x=new I;function M(k){A.fromBufferAttribute(s,k),x.copy(A);let N=a[k];b.copy(N),b.sub(A.multiplyScalar(A.dot(N))).normalize(),C.crossVectors(x,N);let V=C.dot(l[k])<0?-1:1;o.setXYZW(k,b.x,b.y,b.z,V)}for(let k=0,N=n.count;k<N;++k)c[k]&&M(k);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==t.count)n=new pi(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let d=0,f=n.count;d<f;d++)n.setXYZ(d,0,0,0);let s=new I,r=new I,o=new I,a=new I,l=new I,c=new I,h=new I,u=new I;if(e)for(let d=0,f=e.count;d<f;d+=3){let p=e.getX(d+0),_=e.getX(d+1),m=e.getX(d+2);s.fromBufferAttribute(t,p),r.fromBufferAttribute(t,_),o.fromBufferAttribute(t,m),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),a.fromBufferAttribute(n,p),l.fromBufferAttribute(n,_),c.fromBufferAttribute(n,m),a.add(h),l.add(h),c.add(h),n.setXYZ(p,a.x,a.y,a.z),n.setXYZ(_,l.x,l.y,l.z),n.setXYZ(m,c.x,c.y,c.z)}else for(let d=0,f=t.count;d<f;d+=3)s.fromBufferAttribute(t,d+0),r.fromBufferAttribute(t,d+1),o.fromBufferAttribute(t,d+2),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),n.setXYZ(d+0,h.x,h.y,h.z),n.setXYZ(d+1,h.x,h.y,h.z),n.setXYZ(d+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)Dn.fromBufferAttribute(e,t),Dn.normalize(),e.setXYZ(t,Dn.x,Dn.y,Dn.z)}toNonIndexed(){function e(a,l){let c=a.array,h=a.itemSize,u=a.normalized,d=new c.constructor(l.length*h),f=0,p=0;for(let _=0,m=l.length;_<m;_++){a.isInterleavedBufferAttribute?f=l[_]*a.data.stride+a.offset:f=l[_]*h;for(let g=0;g<h;g++)d[p++]=c[f++]}return new pi(d,h,u)}if(this.index===null)return Ze("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new i,n=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,n);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let h=0,u=c.length;h<u;h++){let d=c[h],f=e(d,n);l.push(f)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let n=this.attributes;for(let l in n){let c=n[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let u=0,d=c.length;u<d;u++){let f=c[u];h.push(f.toJSON(e.data))}h.length>0&&(s[l]=h,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let n=e.index;n!==null&&this.setIndex(n.clone());let s=e.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(t))}let r=e.morphAttributes;for(let c in r){let h=[],u=r[c];for(let d=0,f=u.length;d<f;d++)h.push(u[d].clone(t));this.morphAttributes[c]=h}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,h=o.length;c<h;c++){let u=o[c];this.addGroup(u.start,u.count,u.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},wh=class{constructor(e,t){this.isInterleavedBuffer=!0,this.array=e,this.stride=t,this.count=e!==void 0?e.length/t:0,this.usage=Cp,this.updateRanges=[],this.version=0,this.uuid=ur()}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.array=new e.array.constructor(e.array),this.count=e.count,this.stride=e.stride,this.usage=e.usage,this}copyAt(e,t,n){e*=this.stride,n*=t.stride;for(let s=0,r=this.stride;s<r;s++)this.array[e+s]=t.array[n+s];return this}set(e,t=0){return this.array.set(e,t),this}clone(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=ty(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=this.array.slice(0).buffer);let n=new this.array.constructor(e.arrayBuffers[t]),s=new this.constructor(n,this.stride);return s.setUsage(this.usage),s}onUpload(e){return this.onUploadCallback=e,this}toJSON(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=ty(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let n={uuid:this.uuid,buffer:t,type:this.array.constructor.name,stride:this.stride};return n.usage=this.usage,n}};function ty(i){return i.buffer._uuid===void 0&&(i.buffer._uuid=ur()),i.byteOffset===0&&i.byteLength===i.buffer.byteLength?i.buffer._uuid:i.buffer._uuid+":"+i.byteOffset+":"+i.byteLength}var Yn=new I,Ya=class i{constructor(e,t,n,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=e,this.itemSize=t,this.offset=n,this.normalized=s,this._normalizationScale=e!==void 0?ku(e.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(e){this.data.needsUpdate=e}applyMatrix4(e){for(let t=0,n=this.data.count;t<n;t++)Yn.fromBufferAttribute(this,t),Yn.applyMatrix4(e),this.setXYZ(t,Yn.x,Yn.y,Yn.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)Yn.fromBufferAttribute(this,t),Yn.applyNormalMatrix(e),this.setXYZ(t,Yn.x,Yn.y,Yn.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)Yn.fromBufferAttribute(this,t),Yn.transformDirection(e),this.setXYZ(t,Yn.x,Yn.y,Yn.z);return this}getComponent(e,t){let n=this.array[e*this.data.stride+this.offset+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.data.array[e*this.data.stride+this.offset+t]=n,this}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset]=t,this}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+1]=t,this}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+2]=t,this}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+3]=t,this}getX(e){let t=this.data.array[e*this.data.stride+this.offset];return this.normalized&&(t=this._denormalize(t)),t}getY(e){let t=this.data.array[e*this.data.stride+this.offset+1];return this.normalized&&(t=this._denormalize(t)),t}getZ(e){let t=this.data.array[e*this.data.stride+this.offset+2];return this.normalized&&(t=this._denormalize(t)),t}getW(e){let t=this.data.array[e*this.data.stride+this.offset+3];return this.normalized&&(t=this._denormalize(t)),t}setXY(e,t,n){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.data.array[e+0]=t,this.data.array[e+1]=n,this}setXYZ(e,t,n,s){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s)),this.data.array[e+0]=t,this.data.array[e+1]=n,this.data.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.data.array[e+0]=t,this.data.array[e+1]=n,this.data.array[e+2]=s,this.data.array[e+3]=r,this}clone(e){if(e===void 0){Wa("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return new pi(new this.array.constructor(t),this.itemSize,this.normalized)}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.clone(e)),new i(e.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(e){if(e===void 0){Wa("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:t,normalized:this.normalized}}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.toJSON(e)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Lp(e,this.data.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Dp(e,this.data.array)}},Bf=new I,Xw=new I,Yw=new st,fi=class{constructor(e=new I(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,s){return this.normal.set(e,t,n),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){let s=Bf.subVectors(n,t).cross(Xw.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,n=!0){let s=e.delta(Bf),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return n===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let n=t||Yw.getNormalMatrix(e),s=this.coplanarPoint(Bf).applyMatrix4(e),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},Zw=0,zi=class extends Bi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Zw++}),this.uuid=ur(),this.name="",this.type="Material",this.blending=qo,this.side=cr,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=lp,this.blendDst=cp,this.blendEquation=Or,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new it(0,0,0),this.blendAlpha=0,this.depthFunc=Do,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Jy,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=hh,this.stencilZFail=hh,this.stencilZPass=hh,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let n=e[t];if(n===void 0){Ze(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ze(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new it().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(n=>new fi().fromJSON(n))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let n=e.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new Me().fromArray(n)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Me().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,n=null;if(t!==null){let s=t.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=t[r].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}},Vo=class extends zi{constructor(e){super(),this.isSpriteMaterial=!0,this.type="SpriteMaterial",this.color=new it(16777215),this.map=null,this.alphaMap=null,this.rotation=0,this.sizeAttenuation=!0,this.transparent=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.alphaMap=e.alphaMap,this.rotation=e.rotation,this.sizeAttenuation=e.sizeAttenuation,this.fog=e.fog,this}},wo,La=new I,Eo=new I,To=new I,Ao=new Me,Da=new Me,lx=new St,Vc=new I,Na=new I,Gc=new I,ny=new Me,zf=new Me,iy=new Me,Za=class extends wn{constructor(e=new Vo){if(super(),this.isSprite=!0,this.type="Sprite",wo===void 0){wo=new Nt;let t=new Float32Array([-.5,-.5,0,0,0,.5,-.5,0,1,0,.5,.5,0,1,1,-.5,.5,0,0,1]),n=new wh(t,5);wo.setIndex([0,1,2,0,2,3]),wo.setAttribute("position",new Ya(n,3,0,!1)),wo.setAttribute("uv",new Ya(n,2,3,!1))}this.geometry=wo,this.material=e,this.center=new Me(.5,.5),this.count=1}intersectsFrustum(e){return e.intersectsSprite(this)}raycast(e,t){e.camera===null&&Qe('Sprite: "Raycaster.camera" needs to be set in order to raycast against sprites.'),Eo.setFromMatrixScale(this.matrixWorld),lx.copy(e.camera.matrixWorld),this.modelViewMatrix.multiplyMatrices(e.camera.matrixWorldInverse,this.matrixWorld),To.setFromMatrixPosition(this.modelViewMatrix),e.camera.isPerspectiveCamera&&this.material.sizeAttenuation===!1&&Eo.multiplyScalar(-To.z);let n=this.material.rotation,s,r;n!==0&&(r=Math.cos(n),s=Math.sin(n));let o=this.center;Hc(Vc.set(-.5,-.5,0),To,o,Eo,s,r),Hc(Na.set(.5,-.5,0),To,o,Eo,s,r),Hc(Gc.set(.5,.5,0),To,o,Eo,s,r),ny.set(0,0),zf.set(1,0),iy.set(1,1);let a=e.ray.intersectTriangle(Vc,Na,Gc,!1,La);if(a===null&&(Hc(Na.set(-.5,.5,0),To,o,Eo,s,r),zf.set(0,1),a=e.ray.intersectTriangle(Vc,Gc,Na,!1,La),a===null))return;let l=e.ray.origin.distanceTo(La);l<e.near||l>e.far||t.push({distance:l,point:La.clone(),uv:rs.getInterpolation(La,Vc,Na,Gc,ny,zf,iy,new Me),face:null,object:this})}copy(e,t){return super.copy(e,t),e.center!==void 0&&this.center.copy(e.center),this.material=e.material,this}toJSON(e){let t=super.toJSON(e);return t.object.center=this.center.toArray(),t}};function Hc(i,e,t,n,s,r){Ao.subVectors(i,t).addScalar(.5).multiply(n),s!==void 0?(Da.x=r*Ao.x-s*Ao.y,Da.y=s*Ao.x+r*Ao.y):Da.copy(Ao),i.copy(e),i.x+=Da.x,i.y+=Da.y,i.applyMatrix4(lx)}var Es=new I,Vf=new I,Wc=new I,$c=new I,er=class{constructor(e=new I,t=new I(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Es)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=Es.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Es.copy(this.origin).addScaledVector(this.direction,t),Es.distanceToSquared(e))}distanceSqToSegment(e,t,n,s){Vf.copy(e).add(t).multiplyScalar(.5),Wc.copy(t).sub(e).normalize(),$c.copy(this.origin).sub(Vf);let r=e.distanceTo(t)*.5,o=-this.direction.dot(Wc),a=$c.dot(this.direction),l=-$c.dot(Wc),c=$c.lengthSq(),h=Math.abs(1-o*o),u,d,f,p;if(h>0)if(u=o*l-a,d=o*a-l,p=r*h,u>=0)if(d>=-p)if(d<=p){let _=1/h;u*=_,d*=_,f=u*(u+o*d+2*a)+d*(o*u+d+2*l)+c}else d=r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;else d=-r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;else d<=-p?(u=Math.max(0,-(-o*r+a)),d=u>0?-r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+c):d<=p?(u=0,d=Math.min(Math.max(-r,-l),r),f=d*(d+2*l)+c):(u=Math.max(0,-(o*r+a)),d=u>0?r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+c);else d=o>0?-r:r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(Vf).addScaledVector(Wc,d),f}intersectSphere(e,t){if(e.radius<0)return null;Es.subVectors(e.center,this.origin);let n=Es.dot(this.direction),s=Es.dot(Es)-n*n,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){let n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,s,r,o,a,l,c=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,d=this.origin;return c>=0?(n=(e.min.x-d.x)*c,s=(e.max.x-d.x)*c):(n=(e.max.x-d.x)*c,s=(e.min.x-d.x)*c),h>=0?(r=(e.min.y-d.y)*h,o=(e.max.y-d.y)*h):(r=(e.max.y-d.y)*h,o=(e.min.y-d.y)*h),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),u>=0?(a=(e.min.z-d.z)*u,l=(e.max.z-d.z)*u):(a=(e.max.z-d.z)*u,l=(e.min.z-d.z)*u),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,t)}intersectsBox(e){return this.intersectBox(e,Es)!==null}intersectTriangle(e,t,n,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,h=a.z,u=e.x-o.x,d=e.y-o.y,f=e.z-o.z,p=t.x-o.x,_=t.y-o.y,m=t.z-o.z,g=n.x-o.x,y=n.y-o.y,T=n.z-o.z,b=Math.abs(l),C=Math.abs(c),A=Math.abs(h),x,M,k,N,D,V,W,U,G,Z,z,ce;if(b>=C&&b>=A?(k=l,V=u,G=p,ce=g,l>=0?(x=c,M=h,N=d,D=f,W=_,U=m,Z=y,z=T):(x=h,M=c,N=f,D=d,W=m,U=_,Z=T,z=y)):C>=A?(k=c,V=d,G=_,ce=y,c>=0?(x=h,M=l,N=f,D=u,W=m,U=p,Z=T,z=g):(x=l,M=h,N=u,D=f,W=p,U=m,Z=g,z=T)):(k=h,V=f,G=m,ce=T,h>=0?(x=l,M=c,N=u,D=d,W=p,U=_,Z=g,z=y):(x=c,M=l,N=d,D=u,W=_,U=p,Z=y,z=g)),k===0)return null;let j=x/k,K=M/k,ie=1/k,de=N-j*V,ue=D-K*V,Q=W-j*G,ge=U-K*G,xe=Z-j*ce,Re=z-K*ce,we=xe*ge-Re*Q,qe=de*Re-ue*xe,at=Q*ue-ge*de;if(s){if(we<0||qe<0||at<0)return null}else if((we<0||qe<0||at<0)&&(we>0||qe>0||at>0))return null;let We=we+qe+at;if(We===0)return null;let mt=ie*(we*V+qe*G+at*ce);return(We>0?mt<0:mt>0)?null:this.at(mt/We,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Rs=class extends zi{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new it(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new as,this.combine=Kh,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},sy=new St,Pr=new er,qc=new Cs,ry=new I,Xc=new I,Yc=new I,Zc=new I,Gf=new I,jc=new I,oy=new I,Jc=new I,Mt=class extends wn{constructor(e=new Nt,t=new Rs){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){jc.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=a[l],u=r[l];h!==0&&(Gf.fromBufferAttribute(u,e),o?jc.addScaledVector(Gf,h):jc.addScaledVector(Gf.sub(t),h))}t.add(jc)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),qc.copy(n.boundingSphere),qc.applyMatrix4(r),Pr.copy(e.ray).recast(e.near),!(qc.containsPoint(Pr.origin)===!1&&(Pr.intersectSphere(qc,ry)===null||Pr.origin.distanceToSquared(ry)>(e.far-e.near)**2))&&(sy.copy(r).invert(),Pr.copy(e.ray).applyMatrix4(sy),!(n.boundingBox!==null&&Pr.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(e,t,Pr)))}_computeIntersections(e,t,n){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,u=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,_=d.length;p<_;p++){let m=d[p],g=o[m.materialIndex],y=Math.max(m.start,f.start),T=Math.min(a.count,Math.min(m.start+m.count,f.start+f.count));for(let b=y,C=T;b<C;b+=3){let A=a.getX(b),x=a.getX(b+1),M=a.getX(b+2);s=Kc(this,g,e,n,c,h,u,A,x,M),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let p=Math.max(0,f.start),_=Math.min(a.count,f.start+f.count);for(let m=p,g=_;m<g;m+=3){let y=a.getX(m),T=a.getX(m+1),b=a.getX(m+2);s=Kc(this,o,e,n,c,h,u,y,T,b),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let p=0,_=d.length;p<_;p++){let m=d[p],g=o[m.materialIndex],y=Math.max(m.start,f.start),T=Math.min(l.count,Math.min(m.start+m.count,f.start+f.count));for(let b=y,C=T;b<C;b+=3){let A=b,x=b+1,M=b+2;s=Kc(this,g,e,n,c,h,u,A,x,M),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let p=Math.max(0,f.start),_=Math.min(l.count,f.start+f.count);for(let m=p,g=_;m<g;m+=3){let y=m,T=m+1,b=m+2;s=Kc(this,o,e,n,c,h,u,y,T,b),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}}};function jw(i,e,t,n,s,r,o,a){let l;if(e.side===Kn?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,e.side===cr,a),l===null)return null;Jc.copy(a),Jc.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(Jc);return c<t.near||c>t.far?null:{distance:c,point:Jc.clone(),object:i}}function Kc(i,e,t,n,s,r,o,a,l,c){i.getVertexPosition(a,Xc),i.getVertexPosition(l,Yc),i.getVertexPosition(c,Zc);let h=jw(i,e,t,n,Xc,Yc,Zc,oy);if(h){let u=new I;rs.getBarycoord(oy,Xc,Yc,Zc,u),s&&(h.uv=rs.getInterpolatedAttribute(s,a,l,c,u,new Me)),r&&(h.uv1=rs.getInterpolatedAttribute(r,a,l,c,u,new Me)),o&&(h.normal=rs.getInterpolatedAttribute(o,a,l,c,u,new I),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));let d={a,b:l,c,normal:new I,materialIndex:0};rs.getNormal(Xc,Yc,Zc,d.normal),h.face=d,h.barycoord=u}return h}var Eh=class extends Jn{constructor(e=null,t=1,n=1,s,r,o,a,l,c=Nn,h=Nn,u,d){super(null,o,a,l,c,h,s,r,u,d),this.isDataTexture=!0,this.image={data:e,width:t,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Ir=new Cs,Jw=new Me(.5,.5),Qc=new I,tr=class{constructor(e=new fi,t=new fi,n=new fi,s=new fi,r=new fi,o=new fi){this.planes=[e,t,n,s,r,o]}set(e,t,n,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=wi,n=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],h=r[4],u=r[5],d=r[6],f=r[7],p=r[8],_=r[9],m=r[10],g=r[11],y=r[12],T=r[13],b=r[14],C=r[15];if(s[0].setComponents(c-o,f-h,g-p,C-y).normalize(),s[1].setComponents(c+o,f+h,g+p,C+y).normalize(),s[2].setComponents(c+a,f+u,g+_,C+T).normalize(),s[3].setComponents(c-a,f-u,g-_,C-T).normalize(),n)s[4].setComponents(l,d,m,b).normalize(),s[5].setComponents(c-l,f-d,g-m,C-b).normalize();else if(s[4].setComponents(c-l,f-d,g-m,C-b).normalize(),t===wi)s[5].setComponents(c+l,f+d,g+m,C+b).normalize();else if(t===No)s[5].setComponents(l,d,m,b).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),Ir.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),Ir.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(Ir)}intersectsSprite(e){Ir.center.set(0,0,0);let t=Jw.distanceTo(e.center);return Ir.radius=.7071067811865476+t,Ir.applyMatrix4(e.matrixWorld),this.intersectsSphere(Ir)}intersectsSphere(e){let t=this.planes,n=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let n=0;n<6;n++){let s=t[n];if(Qc.x=s.normal.x>0?e.max.x:e.min.x,Qc.y=s.normal.y>0?e.max.y:e.min.y,Qc.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(Qc)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},ay=new St,Th=class i{constructor(){this.coordinateSystem=wi,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,n=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];ay.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new tr),n[s].setFromProjectionMatrix(ay,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,n=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new tr),t[s].copy(n[s]);return this._count=e._count,this}clone(){return new i().copy(this)}};var _n=class extends zi{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new it(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},Ah=new I,Ch=new I,ly=new St,Ua=new er,eh=new Cs,Hf=new I,cy=new I,Ti=class extends wn{constructor(e=new Nt,t=new _n){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[0];for(let s=1,r=t.count;s<r;s++)Ah.fromBufferAttribute(t,s-1),Ch.fromBufferAttribute(t,s),n[s]=n[s-1],n[s]+=Ah.distanceTo(Ch);e.setAttribute("lineDistance",new ut(n,1))}else Ze("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),eh.copy(n.boundingSphere),eh.applyMatrix4(s),eh.radius+=r,e.ray.intersectsSphere(eh)===!1)return;ly.copy(s).invert(),Ua.copy(e.ray).applyMatrix4(ly);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,h=n.index,d=n.attributes.position;if(h!==null){let f=Math.max(0,o.start),p=Math.min(h.count,o.start+o.count);for(let _=f,m=p-1;_<m;_+=c){let g=h.getX(_),y=h.getX(_+1),T=th(this,e,Ua,l,g,y,_);T&&t.push(T)}if(this.isLineLoop){let _=h.getX(p-1),m=h.getX(f),g=th(this,e,Ua,l,_,m,p-1);g&&t.push(g)}}else{let f=Math.max(0,o.start),p=Math.min(d.count,o.start+o.count);for(let _=f,m=p-1;_<m;_+=c){let g=th(this,e,Ua,l,_,_+1,_);g&&t.push(g)}if(this.isLineLoop){let _=th(this,e,Ua,l,p-1,f,p-1);_&&t.push(_)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function th(i,e,t,n,s,r,o){let a=i.geometry.attributes.position;if(Ah.fromBufferAttribute(a,s),Ch.fromBufferAttribute(a,r),t.distanceSqToSegment(Ah,Ch,Hf,cy)>n)return;Hf.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(Hf);if(!(c<e.near||c>e.far))return{distance:c,point:cy.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var hy=new I,uy=new I,gi=class extends Ti{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[];for(let s=0,r=t.count;s<r;s+=2)hy.fromBufferAttribute(t,s),uy.fromBufferAttribute(t,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+hy.distanceTo(uy);e.setAttribute("lineDistance",new ut(n,1))}else Ze("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var ja=class extends Jn{constructor(e=[],t=Fr,n,s,r,o,a,l,c,h){super(e,t,n,s,r,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}},Ja=class extends Jn{constructor(e,t,n,s,r,o,a,l,c){super(e,t,n,s,r,o,a,l,c),this.isCanvasTexture=!0,this.needsUpdate=!0}};var Ps=class extends Jn{constructor(e,t,n=Gi,s,r,o,a=Nn,l=Nn,c,h=As,u=1){if(h!==As&&h!==Ds)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:e,height:t,depth:u};super(d,s,r,o,a,l,h,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Fo(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},Ka=class extends Ps{constructor(e,t=Gi,n=Fr,s,r,o=Nn,a=Nn,l,c=As){let h={width:e,height:e,depth:1},u=[h,h,h,h,h,h];super(e,e,t,n,s,r,o,a,l,c),this.image=u,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},Qa=class extends Jn{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},Vi=class i extends Nt{constructor(e=1,t=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],h=[],u=[],d=0,f=0;p("z","y","x",-1,-1,n,t,e,o,r,0),p("z","y","x",1,-1,n,t,-e,o,r,1),p("x","z","y",1,1,e,n,t,s,o,2),p("x","z","y",1,-1,e,n,-t,s,o,3),p("x","y","z",1,-1,e,t,n,s,r,4),p("x","y","z",-1,-1,e,t,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new ut(c,3)),this.setAttribute("normal",new ut(h,3)),this.setAttribute("uv",new ut(u,2));function p(_,m,g,y,T,b,C,A,x,M,k){let N=b/x,D=C/M,V=b/2,W=C/2,U=A/2,G=x+1,Z=M+1,z=0,ce=0,j=new I;for(let K=0;K<Z;K++){let ie=K*D-W;for(let de=0;de<G;de++){let ue=de*N-V;j[_]=ue*y,j[m]=ie*T,j[g]=U,c.push(j.x,j.y,j.z),j[_]=0,j[m]=0,j[g]=A>0?1:-1,h.push(j.x,j.y,j.z),u.push(de/x),u.push(1-K/M),z+=1}}for(let K=0;K<M;K++)for(let ie=0;ie<x;ie++){let de=d+ie+G*K,ue=d+ie+G*(K+1),Q=d+(ie+1)+G*(K+1),ge=d+(ie+1)+G*K;l.push(de,ue,ge),l.push(ue,Q,ge),ce+=6}a.addGroup(f,ce,k),f+=ce,d+=z}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var el=class i extends Nt{constructor(e=1,t=32,n=0,s=Math.PI*2){super(),this.type="CircleGeometry",this.parameters={radius:e,segments:t,thetaStart:n,thetaLength:s},t=Math.max(3,t);let r=[],o=[],a=[],l=[],c=new I,h=new Me;o.push(0,0,0),a.push(0,0,1),l.push(.5,.5);for(let u=0,d=3;u<=t;u++,d+=3){let f=n+u/t*s;c.x=e*Math.cos(f),c.y=e*Math.sin(f),o.push(c.x,c.y,c.z),a.push(0,0,1),h.x=(o[d]/e+1)/2,h.y=(o[d+1]/e+1)/2,l.push(h.x,h.y)}for(let u=1;u<=t;u++)r.push(u,u+1,0);this.setIndex(r),this.setAttribute("position",new ut(o,3)),this.setAttribute("normal",new ut(a,3)),this.setAttribute("uv",new ut(l,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.segments,e.thetaStart,e.thetaLength)}},nr=class i extends Nt{constructor(e=1,t=1,n=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:n,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let h=[],u=[],d=[],f=[],p=0,_=[],m=n/2,g=0;y(),o===!1&&(e>0&&T(!0),t>0&&T(!1)),this.setIndex(h),this.setAttribute("position",new ut(u,3)),this.setAttribute("normal",new ut(d,3)),this.setAttribute("uv",new ut(f,2));function y(){let b=new I,C=new I,A=0,x=(t-e)/n;for(let M=0;M<=r;M++){let k=[],N=M/r,D=N*(t-e)+e;for(let V=0;V<=s;V++){let W=V/s,U=W*l+a,G=Math.sin(U),Z=Math.cos(U);C.x=D*G,C.y=-N*n+m,C.z=D*Z,u.push(C.x,C.y,C.z),b.set(G,x,Z).normalize(),d.push(b.x,b.y,b.z),f.push(W,1-N),k.push(p++)}_.push(k)}for(let M=0;M<s;M++)for(let k=0;k<r;k++){let N=_[k][M],D=_[k+1][M],V=_[k+1][M+1],W=_[k][M+1];(e>0||k!==0)&&(h.push(N,D,W),A+=3),(t>0||k!==r-1)&&(h.push(D,V,W),A+=3)}c.addGroup(g,A,0),g+=A}function T(b){let C=p,A=new Me,x=new I,M=0,k=b===!0?e:t,N=b===!0?1:-1;for(let V=1;V<=s;V++)u.push(0,m*N,0),d.push(0,N,0),f.push(.5,.5),p++;let D=p;for(let V=0;V<=s;V++){let U=V/s*l+a,G=Math.cos(U),Z=Math.sin(U);x.x=k*Z,x.y=m*N,x.z=k*G,u.push(x.x,x.y,x.z),d.push(0,N,0),A.x=G*.5+.5,A.y=Z*.5*N+.5,f.push(A.x,A.y),p++}for(let V=0;V<s;V++){let W=C+V,U=D+V;b===!0?h.push(U,U+1,W):h.push(U+1,U,W),M+=3}c.addGroup(g,M,b===!0?1:2),g+=M}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}},Go=class i extends nr{constructor(e=1,t=1,n=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,e,t,n,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:e,height:t,radialSegments:n,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(e){return new i(e.radius,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var nh=new I,ih=new I,Wf=new I,sh=new rs,Lr=class extends Nt{constructor(e=null,t=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:e,thresholdAngle:t},e!==null){let s=Math.pow(10,4),r=Math.cos(Io*t),o=e.getIndex(),a=e.getAttribute("position"),l=o?o.count:a.count,c=[0,0,0],h=["a","b","c"],u=new Array(3),d=new Map,f=[];for(let p=0;p<l;p+=3){o?(c[0]=o.getX(p),c[1]=o.getX(p+1),c[2]=o.getX(p+2)):(c[0]=p,c[1]=p+1,c[2]=p+2);let{a:_,b:m,c:g}=sh;if(_.fromBufferAttribute(a,c[0]),m.fromBufferAttribute(a,c[1]),g.fromBufferAttribute(a,c[2]),sh.getNormal(Wf),u[0]=`${Math.round(_.x*s)},${Math.round(_.y*s)},${Math.round(_.z*s)}`,u[1]=`${Math.round(m.x*s)},${Math.round(m.y*s)},${Math.round(m.z*s)}`,u[2]=`${Math.round(g.x*s)},${Math.round(g.y*s)},${Math.round(g.z*s)}`,!(u[0]===u[1]||u[1]===u[2]||u[2]===u[0]))for(let y=0;y<3;y++){let T=(y+1)%3,b=u[y],C=u[T],A=sh[h[y]],x=sh[h[T]],M=`${b}_${C}`,k=`${C}_${b}`,N=d.get(k);N?(Wf.dot(N.normal)<=r&&(f.push(A.x,A.y,A.z),f.push(x.x,x.y,x.z)),d.set(k,null)):d.has(M)||d.set(M,{index0:c[y],index1:c[T],normal:Wf.clone()})}}for(let p of d.values())if(p){let{index0:_,index1:m}=p;nh.fromBufferAttribute(a,_),ih.fromBufferAttribute(a,m),f.push(nh.x,nh.y,nh.z),f.push(ih.x,ih.y,ih.z)}this.setAttribute("position",new ut(f,3))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}},Qn=class{constructor(){this.type="Curve",this.arcLengthDivisions=200,this.needsUpdate=!1,this.cacheArcLengths=null}getPoint(){Ze("Curve: .getPoint() not implemented.")}getPointAt(e,t){let n=this.getUtoTmapping(e);return this.getPoint(n,t)}getPoints(e=5){let t=[];for(let n=0;n<=e;n++)t.push(this.getPoint(n/e));return t}getSpacedPoints(e=5){let t=[];for(let n=0;n<=e;n++)t.push(this.getPointAt(n/e));return t}getLength(){let e=this.getLengths();return e[e.length-1]}getLengths(e=this.arcLengthDivisions){if(this.cacheArcLengths&&this.cacheArcLengths.length===e+1&&!this.needsUpdate)return this.cacheArcLengths;this.needsUpdate=!1;let t=[],n,s=this.getPoint(0),r=0;t.push(0);for(let o=1;o<=e;o++)n=this.getPoint(o/e),r+=n.distanceTo(s),t.push(r),s=n;return this.cacheArcLengths=t,t}updateArcLengths(){this.needsUpdate=!0,this.getLengths()}getUtoTmapping(e,t=null){let n=this.getLengths(),s=0,r=n.length,o;t?o=t:o=e*n[r-1];let a=0,l=r-1,c;for(;a<=l;)if(s=Math.floor(a+(l-a)/2),c=n[s]-o,c<0)a=s+1;else if(c>0)l=s-1;else{l=s;break}if(s=l,n[s]===o)return s/(r-1);let h=n[s],d=n[s+1]-h,f=(o-h)/d;return(s+f)/(r-1)}getTangent(e,t){let s=e-1e-4,r=e+1e-4;s<0&&(s=0),r>1&&(r=1);let o=this.getPoint(s),a=this.getPoint(r),l=t||(o.isVector2?new Me:new I);return l.copy(a).sub(o).normalize(),l}getTangentAt(e,t){let n=this.getUtoTmapping(e);return this.getTangent(n,t)}computeFrenetFrames(e,t=!1){let n=new I,s=[],r=[],o=[],a=new I,l=new St;for(let f=0;f<=e;f++){let p=f/e;s[f]=this.getTangentAt(p,new I)}r[0]=new I,o[0]=new I;let c=Number.MAX_VALUE,h=Math.abs(s[0].x),u=Math.abs(s[0].y),d=Math.abs(s[0].z);h<=c&&(c=h,n.set(1,0,0)),u<=c&&(c=u,n.set(0,1,0)),d<=c&&n.set(0,0,1),a.crossVectors(s[0],n).normalize(),r[0].crossVectors(s[0],a),o[0].crossVectors(s[0],r[0]);for(let f=1;f<=e;f++){if(r[f]=r[f-1].clone(),o[f]=o[f-1].clone(),a.crossVectors(s[f-1],s[f]),a.length()>Number.EPSILON){a.normalize();let p=Math.acos(ht(s[f-1].dot(s[f]),-1,1));r[f].applyMatrix4(l.makeRotationAxis(a,p))}o[f].crossVectors(s[f],r[f])}if(t===!0){let f=Math.acos(ht(r[0].dot(r[e]),-1,1));f/=e,s[0].dot(a.crossVectors(r[0],r[e]))>0&&(f=-f);for(let p=1;p<=e;p++)r[p].applyMatrix4(l.makeRotationAxis(s[p],f*p)),o[p].crossVectors(s[p],r[p])}return{tangents:s,normals:r,binormals:o}}clone(){return new this.constructor().copy(this)}copy(e){return this.arcLengthDivisions=e.arcLengthDivisions,this.cacheArcLengths=null,this}toJSON(){let e={metadata:{version:4.7,type:"Curve",generator:"Curve.toJSON"}};return e.arcLengthDivisions=this.arcLengthDivisions,e.type=this.type,e}fromJSON(e){return this.arcLengthDivisions=e.arcLengthDivisions,this.cacheArcLengths=null,this}},tl=class extends Qn{constructor(e=0,t=0,n=1,s=1,r=0,o=Math.PI*2,a=!1,l=0){super(),this.isEllipseCurve=!0,this.type="EllipseCurve",this.aX=e,this.aY=t,this.xRadius=n,this.yRadius=s,this.aStartAngle=r,this.aEndAngle=o,this.aClockwise=a,this.aRotation=l}getPoint(e,t=new Me){let n=t,s=Math.PI*2,r=this.aEndAngle-this.aStartAngle,o=Math.abs(r)<Number.EPSILON;for(;r<0;)r+=s;for(;r>s;)r-=s;r<Number.EPSILON&&(o?r=0:r=s),this.aClockwise===!0&&!o&&(r===s?r=-s:r=r-s);let a=this.aStartAngle+e*r,l=this.aX+this.xRadius*Math.cos(a),c=this.aY+this.yRadius*Math.sin(a);if(this.aRotation!==0){let h=Math.cos(this.aRotation),u=Math.sin(this.aRotation),d=l-this.aX,f=c-this.aY;l=d*h-f*u+this.aX,c=d*u+f*h+this.aY}return n.set(l,c)}copy(e){return super.copy(e),this.aX=e.aX,this.aY=e.aY,this.xRadius=e.xRadius,this.yRadius=e.yRadius,this.aStartAngle=e.aStartAngle,this.aEndAngle=e.aEndAngle,this.aClockwise=e.aClockwise,this.aRotation=e.aRotation,this}toJSON(){let e=super.toJSON();return e.aX=this.aX,e.aY=this.aY,e.xRadius=this.xRadius,e.yRadius=this.yRadius,e.aStartAngle=this.aStartAngle,e.aEndAngle=this.aEndAngle,e.aClockwise=this.aClockwise,e.aRotation=this.aRotation,e}fromJSON(e){return super.fromJSON(e),this.aX=e.aX,this.aY=e.aY,this.xRadius=e.xRadius,this.yRadius=e.yRadius,this.aStartAngle=e.aStartAngle,this.aEndAngle=e.aEndAngle,this.aClockwise=e.aClockwise,this.aRotation=e.aRotation,this}},Rh=class extends tl{constructor(e,t,n,s,r,o){super(e,t,n,n,s,r,o),this.isArcCurve=!0,this.type="ArcCurve"}};function Up(){let i=0,e=0,t=0,n=0;function s(r,o,a,l){i=r,e=a,t=-3*r+3*o-2*a-l,n=2*r-2*o+a+l}return{initCatmullRom:function(r,o,a,l,c){s(o,a,c*(a-r),c*(l-o))},initNonuniformCatmullRom:function(r,o,a,l,c,h,u){let d=(o-r)/c-(a-r)/(c+h)+(a-o)/h,f=(a-o)/h-(l-o)/(h+u)+(l-a)/u;d*=h,f*=h,s(o,a,d,f)},calc:function(r){let o=r*r,a=o*r;return i+e*r+t*o+n*a}}}var dy=new I,fy=new I,$f=new Up,qf=new Up,Xf=new Up,Ph=class extends Qn{constructor(e=[],t=!1,n="centripetal",s=.5){super(),this.isCatmullRomCurve3=!0,this.type="CatmullRomCurve3",this.points=e,this.closed=t,this.curveType=n,this.tension=s}getPoint(e,t=new I){let n=t,s=this.points,r=s.length,o=(r-(this.closed?0:1))*e,a=Math.floor(o),l=o-a;this.closed?a+=a>0?0:(Math.floor(Math.abs(a)/r)+1)*r:l===0&&a===r-1&&(a=r-2,l=1);let c,h;this.closed||a>0?c=s[(a-1)%r]:(fy.subVectors(s[0],s[1]).add(s[0]),c=fy);let u=s[a%r],d=s[(a+1)%r];if(this.closed||a+2<r?h=s[(a+2)%r]:(dy.subVectors(s[r-1],s[r-2]).add(s[r-1]),h=dy),this.curveType==="centripetal"||this.curveType==="chordal"){let f=this.curveType==="chordal"?.5:.25,p=Math.pow(c.distanceToSquared(u),f),_=Math.pow(u.distanceToSquared(d),f),m=Math.pow(d.distanceToSquared(h),f);_<1e-4&&(_=1),p<1e-4&&(p=_),m<1e-4&&(m=_),$f.initNonuniformCatmullRom(c.x,u.x,d.x,h.x,p,_,m),qf.initNonuniformCatmullRom(c.y,u.y,d.y,h.y,p,_,m),Xf.initNonuniformCatmullRom(c.z,u.z,d.z,h.z,p,_,m)}else this.curveType==="catmullrom"&&($f.initCatmullRom(c.x,u.x,d.x,h.x,this.tension),qf.initCatmullRom(c.y,u.y,d.y,h.y,this.tension),Xf.initCatmullRom(c.z,u.z,d.z,h.z,this.tension));return n.set($f.calc(l),qf.calc(l),Xf.calc(l)),n}copy(e){super.copy(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(s.clone())}return this.closed=e.closed,this.curveType=e.curveType,this.tension=e.tension,this}toJSON(){let e=super.toJSON();e.points=[];for(let t=0,n=this.points.length;t<n;t++){let s=this.points[t];e.points.push(s.toArray())}return e.closed=this.closed,e.curveType=this.curveType,e.tension=this.tension,e}fromJSON(e){super.fromJSON(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(new I().fromArray(s))}return this.closed=e.closed,this.curveType=e.curveType,this.tension=e.tension,this}};function py(i,e,t,n,s){let r=(n-e)*.5,o=(s-t)*.5,a=i*i,l=i*a;return(2*t-2*n+r+o)*l+(-3*t+3*n-2*r-o)*a+r*i+t}function Kw(i,e){let t=1-i;return t*t*e}function Qw(i,e){return 2*(1-i)*i*e}function eE(i,e){return i*i*e}function ka(i,e,t,n){return Kw(i,e)+Qw(i,t)+eE(i,n)}function tE(i,e){let t=1-i;return t*t*t*e}function nE(i,e){let t=1-i;return 3*t*t*i*e}function iE(i,e){return 3*(1-i)*i*i*e}function sE(i,e){return i*i*i*e}function Ba(i,e,t,n,s){return tE(i,e)+nE(i,t)+iE(i,n)+sE(i,s)}var Ih=class extends Qn{constructor(e=new Me,t=new Me,n=new Me,s=new Me){super(),this.isCubicBezierCurve=!0,this.type="CubicBezierCurve",this.v0=e,this.v1=t,this.v2=n,this.v3=s}getPoint(e,t=new Me){let n=t,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return n.set(Ba(e,s.x,r.x,o.x,a.x),Ba(e,s.y,r.y,o.y,a.y)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this.v3.copy(e.v3),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e.v3=this.v3.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this.v3.fromArray(e.v3),this}},Lh=class extends Qn{constructor(e=new I,t=new I,n=new I,s=new I){super(),this.isCubicBezierCurve3=!0,this.type="CubicBezierCurve3",this.v0=e,this.v1=t,this.v2=n,this.v3=s}getPoint(e,t=new I){let n=t,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return n.set(Ba(e,s.x,r.x,o.x,a.x),Ba(e,s.y,r.y,o.y,a.y),Ba(e,s.z,r.z,o.z,a.z)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this.v3.copy(e.v3),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e.v3=this.v3.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this.v3.fromArray(e.v3),this}},Dh=class extends Qn{constructor(e=new Me,t=new Me){super(),this.isLineCurve=!0,this.type="LineCurve",this.v1=e,this.v2=t}getPoint(e,t=new Me){let n=t;return e===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(e).add(this.v1)),n}getPointAt(e,t){return this.getPoint(e,t)}getTangent(e,t=new Me){return t.subVectors(this.v2,this.v1).normalize()}getTangentAt(e,t){return this.getTangent(e,t)}copy(e){return super.copy(e),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},Nh=class extends Qn{constructor(e=new I,t=new I){super(),this.isLineCurve3=!0,this.type="LineCurve3",this.v1=e,this.v2=t}getPoint(e,t=new I){let n=t;return e===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(e).add(this.v1)),n}getPointAt(e,t){return this.getPoint(e,t)}getTangent(e,t=new I){return t.subVectors(this.v2,this.v1).normalize()}getTangentAt(e,t){return this.getTangent(e,t)}copy(e){return super.copy(e),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},Uh=class extends Qn{constructor(e=new Me,t=new Me,n=new Me){super(),this.isQuadraticBezierCurve=!0,this.type="QuadraticBezierCurve",this.v0=e,this.v1=t,this.v2=n}getPoint(e,t=new Me){let n=t,s=this.v0,r=this.v1,o=this.v2;return n.set(ka(e,s.x,r.x,o.x),ka(e,s.y,r.y,o.y)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},nl=class extends Qn{constructor(e=new I,t=new I,n=new I){super(),this.isQuadraticBezierCurve3=!0,this.type="QuadraticBezierCurve3",this.v0=e,this.v1=t,this.v2=n}getPoint(e,t=new I){let n=t,s=this.v0,r=this.v1,o=this.v2;return n.set(ka(e,s.x,r.x,o.x),ka(e,s.y,r.y,o.y),ka(e,s.z,r.z,o.z)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},Oh=class extends Qn{constructor(e=[]){super(),this.isSplineCurve=!0,this.type="SplineCurve",this.points=e}getPoint(e,t=new Me){let n=t,s=this.points,r=(s.length-1)*e,o=Math.floor(r),a=r-o,l=s[o===0?o:o-1],c=s[o],h=s[o>s.length-2?s.length-1:o+1],u=s[o>s.length-3?s.length-1:o+2];return n.set(py(a,l.x,c.x,h.x,u.x),py(a,l.y,c.y,h.y,u.y)),n}copy(e){super.copy(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(s.clone())}return this}toJSON(){let e=super.toJSON();e.points=[];for(let t=0,n=this.points.length;t<n;t++){let s=this.points[t];e.points.push(s.toArray())}return e}fromJSON(e){super.fromJSON(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(new Me().fromArray(s))}return this}},rE=Object.freeze({__proto__:null,ArcCurve:Rh,CatmullRomCurve3:Ph,CubicBezierCurve:Ih,CubicBezierCurve3:Lh,EllipseCurve:tl,LineCurve:Dh,LineCurve3:Nh,QuadraticBezierCurve:Uh,QuadraticBezierCurve3:nl,SplineCurve:Oh});var il=class i extends Nt{constructor(e=[new Me(0,-.5),new Me(.5,0),new Me(0,.5)],t=12,n=0,s=Math.PI*2){super(),this.type="LatheGeometry",this.parameters={points:e,segments:t,phiStart:n,phiLength:s},t=Math.floor(t),s=ht(s,0,Math.PI*2);let r=[],o=[],a=[],l=[],c=[],h=1/t,u=new I,d=new Me,f=new I,p=new I,_=new I,m=0,g=0;for(let y=0;y<=e.length-1;y++)switch(y){case 0:m=e[y+1].x-e[y].x,g=e[y+1].y-e[y].y,f.x=g*1,f.y=-m,f.z=g*0,_.copy(f),f.normalize(),l.push(f.x,f.y,f.z);break;case e.length-1:_.normalize(),l.push(_.x,_.y,_.z);break;default:m=e[y+1].x-e[y].x,g=e[y+1].y-e[y].y,f.x=g*1,f.y=-m,f.z=g*0,p.copy(f),f.x+=_.x,f.y+=_.y,f.z+=_.z,f.normalize(),l.push(f.x,f.y,f.z),_.copy(p)}for(let y=0;y<=t;y++){let T=n+y*h*s,b=Math.sin(T),C=Math.cos(T);for(let A=0;A<=e.length-1;A++){u.x=e[A].x*b,u.y=e[A].y,u.z=e[A].x*C,o.push(u.x,u.y,u.z),d.x=y/t,d.y=A/(e.length-1),a.push(d.x,d.y);let x=l[3*A+0]*b,M=l[3*A+1],k=l[3*A+0]*C;c.push(x,M,k)}}for(let y=0;y<t;y++)for(let T=0;T<e.length-1;T++){let b=T+y*e.length,C=b,A=b+e.length,x=b+e.length+1,M=b+1;r.push(C,A,M),r.push(x,M,A)}this.setIndex(r),this.setAttribute("position",new ut(o,3)),this.setAttribute("uv",new ut(a,2)),this.setAttribute("normal",new ut(c,3))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.points,e.segments,e.phiStart,e.phiLength)}};var sl=class i extends Nt{constructor(e=1,t=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(n),l=Math.floor(s),c=a+1,h=l+1,u=e/a,d=t/l,f=[],p=[],_=[],m=[];for(let g=0;g<h;g++){let y=g*d-o;for(let T=0;T<c;T++){let b=T*u-r;p.push(b,-y,0),_.push(0,0,1),m.push(T/a),m.push(1-g/l)}}for(let g=0;g<l;g++)for(let y=0;y<a;y++){let T=y+c*g,b=y+c*(g+1),C=y+1+c*(g+1),A=y+1+c*g;f.push(T,b,A),f.push(b,C,A)}this.setIndex(f),this.setAttribute("position",new ut(p,3)),this.setAttribute("normal",new ut(_,3)),this.setAttribute("uv",new ut(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.widthSegments,e.heightSegments)}},rl=class i extends Nt{constructor(e=.5,t=1,n=32,s=1,r=0,o=Math.PI*2){super(),this.type="RingGeometry",this.parameters={innerRadius:e,outerRadius:t,thetaSegments:n,phiSegments:s,thetaStart:r,thetaLength:o},n=Math.max(3,n),s=Math.max(1,s);let a=[],l=[],c=[],h=[],u=e,d=(t-e)/s,f=new I,p=new Me;for(let _=0;_<=s;_++){for(let m=0;m<=n;m++){let g=r+m/n*o;f.x=u*Math.cos(g),f.y=u*Math.sin(g),l.push(f.x,f.y,f.z),c.push(0,0,1),p.x=(f.x/t+1)/2,p.y=(f.y/t+1)/2,h.push(p.x,p.y)}u+=d}for(let _=0;_<s;_++){let m=_*(n+1);for(let g=0;g<n;g++){let y=g+m,T=y,b=y+n+1,C=y+n+2,A=y+1;a.push(T,b,A),a.push(b,C,A)}}this.setIndex(a),this.setAttribute("position",new ut(l,3)),this.setAttribute("normal",new ut(c,3)),this.setAttribute("uv",new ut(h,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.innerRadius,e.outerRadius,e.thetaSegments,e.phiSegments,e.thetaStart,e.thetaLength)}};var ol=class i extends Nt{constructor(e=1,t=32,n=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:n,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),n=Math.max(2,Math.floor(n));let l=Math.min(o+a,Math.PI),c=0,h=[],u=new I,d=new I,f=[],p=[],_=[],m=[];for(let g=0;g<=n;g++){let y=[],T=g/n,b=o+T*a,C=e*Math.cos(b),A=Math.sqrt(e*e-C*C),x=0;g===0&&o===0?x=.5/t:g===n&&l===Math.PI&&(x=-.5/t);for(let M=0;M<=t;M++){let k=M/t,N=s+k*r;u.x=-A*Math.cos(N),u.y=C,u.z=A*Math.sin(N),p.push(u.x,u.y,u.z),d.copy(u).normalize(),_.push(d.x,d.y,d.z),m.push(k+x,1-T),y.push(c++)}h.push(y)}for(let g=0;g<n;g++)for(let y=0;y<t;y++){let T=h[g][y+1],b=h[g][y],C=h[g+1][y],A=h[g+1][y+1];(g!==0||o>0)&&f.push(T,b,A),(g!==n-1||l<Math.PI)&&f.push(b,C,A)}this.setIndex(f),this.setAttribute("position",new ut(p,3)),this.setAttribute("normal",new ut(_,3)),this.setAttribute("uv",new ut(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};var al=class i extends Nt{constructor(e=1,t=.4,n=12,s=48,r=Math.PI*2,o=0,a=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:e,tube:t,radialSegments:n,tubularSegments:s,arc:r,thetaStart:o,thetaLength:a},n=Math.floor(n),s=Math.floor(s);let l=[],c=[],h=[],u=[],d=new I,f=new I,p=new I;for(let _=0;_<=n;_++){let m=o+_/n*a;for(let g=0;g<=s;g++){let y=g/s*r;f.x=(e+t*Math.cos(m))*Math.cos(y),f.y=(e+t*Math.cos(m))*Math.sin(y),f.z=t*Math.sin(m),c.push(f.x,f.y,f.z),d.x=e*Math.cos(y),d.y=e*Math.sin(y),p.subVectors(f,d).normalize(),h.push(p.x,p.y,p.z),u.push(g/s),u.push(_/n)}}for(let _=1;_<=n;_++)for(let m=1;m<=s;m++){let g=(s+1)*_+m-1,y=(s+1)*(_-1)+m-1,T=(s+1)*(_-1)+m,b=(s+1)*_+m;l.push(g,y,b),l.push(y,T,b)}this.setIndex(l),this.setAttribute("position",new ut(c,3)),this.setAttribute("normal",new ut(h,3)),this.setAttribute("uv",new ut(u,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.tube,e.radialSegments,e.tubularSegments,e.arc,e.thetaStart,e.thetaLength)}};var ll=class i extends Nt{constructor(e=new nl(new I(-1,-1,0),new I(-1,1,0),new I(1,1,0)),t=64,n=1,s=8,r=!1){super(),this.type="TubeGeometry",this.parameters={path:e,tubularSegments:t,radius:n,radialSegments:s,closed:r};let o=e.computeFrenetFrames(t,r);this.tangents=o.tangents,this.normals=o.normals,this.binormals=o.binormals;let a=new I,l=new I,c=new Me,h=new I,u=[],d=[],f=[],p=[];_(),this.setIndex(p),this.setAttribute("position",new ut(u,3)),this.setAttribute("normal",new ut(d,3)),this.setAttribute("uv",new ut(f,2));function _(){for(let T=0;T<t;T++)m(T);m(r===!1?t:0),y(),g()}function m(T){h=e.getPointAt(T/t,h);let b=o.normals[T],C=o.binormals[T];for(let A=0;A<=s;A++){let x=A/s*Math.PI*2,M=Math.sin(x),k=-Math.cos(x);l.x=k*b.x+M*C.x,l.y=k*b.y+M*C.y,l.z=k*b.z+M*C.z,l.normalize(),d.push(l.x,l.y,l.z),a.x=h.x+n*l.x,a.y=h.y+n*l.y,a.z=h.z+n*l.z,u.push(a.x,a.y,a.z)}}function g(){for(let T=1;T<=t;T++)for(let b=1;b<=s;b++){let C=(s+1)*(T-1)+(b-1),A=(s+1)*T+(b-1),x=(s+1)*T+b,M=(s+1)*(T-1)+b;p.push(C,A,M),p.push(A,x,M)}}function y(){for(let T=0;T<=t;T++)for(let b=0;b<=s;b++)c.x=T/t,c.y=b/s,f.push(c.x,c.y)}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}toJSON(){let e=super.toJSON();return e.path=this.parameters.path.toJSON(),e}static fromJSON(e){return new i(new rE[e.path.type]().fromJSON(e.path),e.tubularSegments,e.radius,e.radialSegments,e.closed)}};function Br(i){let e={};for(let t in i){e[t]={};for(let n in i[t]){let s=i[t][n];if(my(s))s.isRenderTargetTexture?(Ze("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=s.clone();else if(Array.isArray(s))if(my(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][n]=r}else e[t][n]=s.slice();else e[t][n]=s}}return e}function Vn(i){let e={};for(let t=0;t<i.length;t++){let n=Br(i[t]);for(let s in n)e[s]=n[s]}return e}function my(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function oE(i){let e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}function Op(i){let e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:bt.workingColorSpace}var cx={clone:Br,merge:Vn},aE=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,lE=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,ls=class extends zi{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=aE,this.fragmentShader=lE,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Br(e.uniforms),this.uniformsGroups=oE(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let n in e.uniforms){let s=e.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=t[s.value]||null;break;case"c":this.uniforms[n].value=new it().setHex(s.value);break;case"v2":this.uniforms[n].value=new Me().fromArray(s.value);break;case"v3":this.uniforms[n].value=new I().fromArray(s.value);break;case"v4":this.uniforms[n].value=new Kt().fromArray(s.value);break;case"m3":this.uniforms[n].value=new st().fromArray(s.value);break;case"m4":this.uniforms[n].value=new St().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let n in e.extensions)this.extensions[n]=e.extensions[n];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},Fh=class extends ls{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}},ir=class extends zi{constructor(e){super(),this.isMeshStandardMaterial=!0,this.type="MeshStandardMaterial",this.defines={STANDARD:""},this.color=new it(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new it(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=El,this.normalScale=new Me(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new as,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.defines={STANDARD:""},this.color.copy(e.color),this.roughness=e.roughness,this.metalness=e.metalness,this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.roughnessMap=e.roughnessMap,this.metalnessMap=e.metalnessMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.envMapIntensity=e.envMapIntensity,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}};var Dr=class extends zi{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new it(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new it(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=El,this.normalScale=new Me(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new as,this.combine=Kh,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},kh=class extends zi{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Zy,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},Bh=class extends zi{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function Co(i,e){return!i||i.constructor===e?i:typeof e.BYTES_PER_ELEMENT=="number"?new e(i):Array.prototype.slice.call(i)}function rh(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var sr=class{constructor(e,t,n,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(n),this.sampleValues=t,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,n=this._cachedIndex,s=t[n],r=t[n-1];n:{e:{let o;t:{i:if(!(e<s)){for(let a=n+2;;){if(s===void 0){if(e<r)break i;return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=t[++n],e<s)break e}o=t.length;break t}if(!(e>=r)){let a=t[1];e<a&&(n=2,r=a);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=t[--n-1],e>=r)break e}o=n,n=0;break t}break n}for(;n<o;){let a=n+o>>>1;e<t[a]?o=a:n=a+1}if(s=t[n],r=t[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=n[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},zh=class extends sr{constructor(e,t,n,s){super(e,t,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Jf,endingEnd:Jf}}intervalChanged_(e,t,n){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Kf:r=e,a=2*t-n;break;case Qf:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case Kf:o=e,l=2*n-t;break;case Qf:o=1,l=n+s[1]-s[0];break;default:o=e-1,l=t}let c=(n-t)*.5,h=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-n),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=this._offsetPrev,u=this._offsetNext,d=this._weightPrev,f=this._weightNext,p=(n-t)/(s-t),_=p*p,m=_*p,g=-d*m+2*d*_-d*p,y=(1+d)*m+(-1.5-2*d)*_+(-.5+d)*p+1,T=(-1-f)*m+(1.5+f)*_+.5*p,b=f*m-f*_;for(let C=0;C!==a;++C)r[C]=g*o[h+C]+y*o[c+C]+T*o[l+C]+b*o[u+C];return r}},Vh=class extends sr{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=(n-t)/(s-t),u=1-h;for(let d=0;d!==a;++d)r[d]=o[c+d]*u+o[l+d]*h;return r}},Gh=class extends sr{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e){return this.copySampleValue_(e-1)}},Hh=class extends sr{interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=this.inTangents,u=this.outTangents;if(!h||!u){let p=(n-t)/(s-t),_=1-p;for(let m=0;m!==a;++m)r[m]=o[c+m]*_+o[l+m]*p;return r}let d=a*2,f=e-1;for(let p=0;p!==a;++p){let _=o[c+p],m=o[l+p],g=f*d+p*2,y=u[g],T=u[g+1],b=e*d+p*2,C=h[b],A=h[b+1],x=hE(n,t,y,C,s);r[p]=hx(x,_,T,A,m)}return r}};function hx(i,e,t,n,s){let r=1-i;return r*r*r*e+3*r*r*i*t+3*r*i*i*n+i*i*i*s}function cE(i,e,t,n,s){let r=1-i;return 3*r*r*(t-e)+6*r*i*(n-t)+3*i*i*(s-n)}function hE(i,e,t,n,s){let r=(i-e)/(s-e);for(let o=0;o<8;o++){let a=hx(r,e,t,n,s)-i;if(Math.abs(a)<1e-10)break;let l=cE(r,e,t,n,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var _i=class{constructor(e,t,n,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=Co(t,this.TimeBufferType),this.values=Co(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,n;if(t.toJSON!==this.toJSON)n=t.toJSON(e);else{n={name:e.name,times:Co(e.times,Array),values:Co(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(n.interpolation=s),rh(e.settings)&&(n.settings={inTangents:Co(e.settings.inTangents,Array),outTangents:Co(e.settings.outTangents,Array)})}return n.type=e.ValueTypeName,n}InterpolantFactoryMethodDiscrete(e){return new Gh(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new Vh(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new zh(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new Hh(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case za:t=this.InterpolantFactoryMethodDiscrete;break;case vh:t=this.InterpolantFactoryMethodLinear;break;case ch:t=this.InterpolantFactoryMethodSmooth;break;case jf:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return Ze("KeyframeTrack:",n),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return za;case this.InterpolantFactoryMethodLinear:return vh;case this.InterpolantFactoryMethodSmooth:return ch;case this.InterpolantFactoryMethodBezier:return jf}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]+=e;rh(this.settings)&&(gy(this.settings.inTangents,e),gy(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]*=e;rh(this.settings)&&(_y(this.settings.inTangents,e),_y(this.settings.outTangents,e))}return this}trim(e,t){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<e;)++r;for(;o!==-1&&n[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(Qe("KeyframeTrack: Invalid value size in track.",this),e=!1);let n=this.times,s=this.values,r=n.length;r===0&&(Qe("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){Qe("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){Qe("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&yw(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){Qe("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===ch,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],h=e[a+1];if(c!==h&&(a!==1||c!==e[0]))if(s)l=!0;else{let u=a*n,d=u-n,f=u+n;for(let p=0;p!==n;++p){let _=t[u+p];if(_!==t[d+p]||_!==t[f+p]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let u=a*n,d=o*n;for(let f=0;f!==n;++f)t[d+f]=t[u+f]}++o}}if(r>0){e[o]=e[r];for(let a=r*n,l=o*n,c=0;c!==n;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*n)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),n=this.constructor,s=new n(this.name,e,t);return s.createInterpolant=this.createInterpolant,rh(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function gy(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]+=e}function _y(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]*=e}_i.prototype.ValueTypeName="";_i.prototype.TimeBufferType=Float32Array;_i.prototype.ValueBufferType=Float32Array;_i.prototype.DefaultInterpolation=vh;var rr=class extends _i{constructor(e,t,n){super(e,t,n)}};rr.prototype.ValueTypeName="bool";rr.prototype.ValueBufferType=Array;rr.prototype.DefaultInterpolation=za;rr.prototype.InterpolantFactoryMethodLinear=void 0;rr.prototype.InterpolantFactoryMethodSmooth=void 0;var Wh=class extends _i{constructor(e,t,n,s){super(e,t,n,s)}};Wh.prototype.ValueTypeName="color";var $h=class extends _i{constructor(e,t,n,s){super(e,t,n,s)}};$h.prototype.ValueTypeName="number";var qh=class extends sr{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-t)/(s-t),c=e*a;for(let h=c+a;c!==h;c+=4)Mn.slerpFlat(r,0,o,c-a,o,c,l);return r}},cl=class extends _i{constructor(e,t,n,s){super(e,t,n,s)}InterpolantFactoryMethodLinear(e){return new qh(this.times,this.values,this.getValueSize(),e)}};cl.prototype.ValueTypeName="quaternion";cl.prototype.InterpolantFactoryMethodSmooth=void 0;var or=class extends _i{constructor(e,t,n){super(e,t,n)}};or.prototype.ValueTypeName="string";or.prototype.ValueBufferType=Array;or.prototype.DefaultInterpolation=za;or.prototype.InterpolantFactoryMethodLinear=void 0;or.prototype.InterpolantFactoryMethodSmooth=void 0;var Xh=class extends _i{constructor(e,t,n,s){super(e,t,n,s)}};Xh.prototype.ValueTypeName="vector";var Yh=class{constructor(e,t,n){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=n,this._abortController=null,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,u){return c.push(h,u),this},this.removeHandler=function(h){let u=c.indexOf(h);return u!==-1&&c.splice(u,2),this},this.getHandler=function(h){for(let u=0,d=c.length;u<d;u+=2){let f=c[u],p=c[u+1];if(f.global&&(f.lastIndex=0),f.test(h))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},ux=new Yh,Zh=class{constructor(e){this.manager=e!==void 0?e:ux,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let n=this;return new Promise(function(s,r){n.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};Zh.DEFAULT_MATERIAL_NAME="__DEFAULT";var hl=class extends wn{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new it(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}},ul=class extends hl{constructor(e,t,n){super(e,n),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(wn.DEFAULT_UP),this.updateMatrix(),this.groundColor=new it(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}toJSON(e){let t=super.toJSON(e);return t.object.groundColor=this.groundColor.getHex(),t}},Yf=new St,yy=new I,xy=new I,jh=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Me(512,512),this.mapType=ei,this.map=null,this.mapPass=null,this.matrix=new St,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new tr,this._frameExtents=new Me(1,1),this._viewportCount=1,this._viewports=[new Kt(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;yy.setFromMatrixPosition(e.matrixWorld),t.position.copy(yy),xy.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(xy),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,n,s){Yf.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),n.setFromProjectionMatrix(Yf,e.coordinateSystem,e.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;e.coordinateSystem===No||e.reversedDepth?t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),t.multiply(Yf)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},oh=new I,ah=new Mn,ss=new I,dl=class extends wn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new St,this.projectionMatrix=new St,this.projectionMatrixInverse=new St,this.coordinateSystem=wi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(oh,ah,ss),ss.x===1&&ss.y===1&&ss.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(oh,ah,ss.set(1,1,1)).invert()}updateWorldMatrix(e,t,n=!1){super.updateWorldMatrix(e,t,n),this.matrixWorld.decompose(oh,ah,ss),ss.x===1&&ss.y===1&&ss.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(oh,ah,ss.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Qs=new I,vy=new Me,by=new Me,Zn=class extends dl{constructor(e=50,t=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=Oo*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(Io*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Oo*2*Math.atan(Math.tan(Io*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){Qs.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(Qs.x,Qs.y).multiplyScalar(-e/Qs.z),Qs.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(Qs.x,Qs.y).multiplyScalar(-e/Qs.z)}getViewSize(e,t){return this.getViewBounds(e,vy,by),t.subVectors(by,vy)}setViewOffset(e,t,n,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(Io*.5*this.fov)/this.zoom,n=2*t,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-n,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var Nr=class extends dl{constructor(e=-1,t=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-e,o=n+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},ep=class extends jh{constructor(){super(new Nr(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},fl=class extends hl{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(wn.DEFAULT_UP),this.updateMatrix(),this.target=new wn,this.shadow=new ep}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}};var Ro=-90,Po=1,Ho=class extends wn{constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Zn(Ro,Po,e,t);s.layers=this.layers,this.add(s);let r=new Zn(Ro,Po,e,t);r.layers=this.layers,this.add(r);let o=new Zn(Ro,Po,e,t);o.layers=this.layers,this.add(o);let a=new Zn(Ro,Po,e,t);a.layers=this.layers,this.add(a);let l=new Zn(Ro,Po,e,t);l.layers=this.layers,this.add(l);let c=new Zn(Ro,Po,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[n,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===wi)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===No)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,h]=this.children,u=e.getRenderTarget(),d=e.getActiveCubeFace(),f=e.getActiveMipmapLevel(),p=e.xr.enabled;e.xr.enabled=!1;let _=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let m=!1;e.isWebGLRenderer===!0?m=e.state.buffers.depth.getReversed():m=e.reversedDepthBuffer,e.setRenderTarget(n,0,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(n,1,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(n,2,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(n,3,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(n,4,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),n.texture.mipmapsAutoUpdate=_,e.setRenderTarget(n,5,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,h),e.setRenderTarget(u,d,f),e.xr.enabled=p,n.texture.needsPMREMUpdate=!0}},Jh=class extends Zn{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var Fp="\\[\\]\\.:\\/",uE=new RegExp("["+Fp+"]","g"),kp="[^"+Fp+"]",dE="[^"+Fp.replace("\\.","")+"]",fE=/((?:WC+[\/:])*)/.source.replace("WC",kp),pE=/(WCOD+)?/.source.replace("WCOD",dE),mE=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",kp),gE=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",kp),_E=new RegExp("^"+fE+pE+mE+gE+"$"),yE=["material","materials","bones","map"],tp=class{constructor(e,t,n){let s=n||Zt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(e,t)}setValue(e,t){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].unbind()}},Zt=class i{constructor(e,t,n){this.path=t,this.parsedPath=n||i.parseTrackName(t),this.node=i.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,n){return e&&e.isAnimationObjectGroup?new i.Composite(e,t,n):new i(e,t,n)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(uE,"")}static parseTrackName(e){let t=_E.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let n={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);yE.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return n}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let n=e.skeleton.getBoneByName(t);if(n!==void 0)return n}if(e.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=n(a.children);if(l)return l}return null},s=n(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)e[t++]=n[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,n=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=i.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Ze("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=t.objectIndex;switch(n){case"materials":if(!e.material){Qe("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){Qe("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){Qe("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let h=0;h<e.length;h++)if(e[h].name===c){c=h;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){Qe("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){Qe("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[n]===void 0){Qe("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[n]}if(c!==void 0){if(e[c]===void 0){Qe("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;Qe("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){Qe("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){Qe("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Zt.Composite=tp;Zt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Zt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Zt.prototype.GetterByBindingType=[Zt.prototype._getValue_direct,Zt.prototype._getValue_array,Zt.prototype._getValue_arrayElement,Zt.prototype._getValue_toArray];Zt.prototype.SetterByBindingTypeAndVersioning=[[Zt.prototype._setValue_direct,Zt.prototype._setValue_direct_setNeedsUpdate,Zt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Zt.prototype._setValue_array,Zt.prototype._setValue_array_setNeedsUpdate,Zt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Zt.prototype._setValue_arrayElement,Zt.prototype._setValue_arrayElement_setNeedsUpdate,Zt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Zt.prototype._setValue_fromArray,Zt.prototype._setValue_fromArray_setNeedsUpdate,Zt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var Z3=new Float32Array(1);var Sy=new St,pl=class{constructor(e,t,n=0,s=1/0){this.ray=new er(e,t),this.near=n,this.far=s,this.camera=null,this.layers=new ko,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(e,t){this.ray.set(e,t)}setFromCamera(e,t){t.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(e.x,e.y,.5).unproject(t).sub(this.ray.origin).normalize(),this.camera=t):t.isOrthographicCamera?(this.ray.origin.set(e.x,e.y,t.projectionMatrix.elements[14]).unproject(t),this.ray.direction.set(0,0,-1).transformDirection(t.matrixWorld),this.camera=t):Qe("Raycaster: Unsupported camera type: "+t.type)}setFromXRController(e){return Sy.identity().extractRotation(e.matrixWorld),this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(Sy),this}intersectObject(e,t=!0,n=[]){return np(e,this,n,t),n.sort(My),n}intersectObjects(e,t=!0,n=[]){for(let s=0,r=e.length;s<r;s++)np(e[s],this,n,t);return n.sort(My),n}};function My(i,e){return i.distance-e.distance}function np(i,e,t,n){let s=!0;if(i.layers.test(e.layers)&&i.raycast(e,t)===!1&&(s=!1),s===!0&&n===!0){let r=i.children;for(let o=0,a=r.length;o<a;o++)np(r[o],e,t,!0)}}var Wo=class{constructor(e=1,t=0,n=0){this.radius=e,this.phi=t,this.theta=n}set(e,t,n){return this.radius=e,this.phi=t,this.theta=n,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=ht(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,n){return this.radius=Math.sqrt(e*e+t*t+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,n),this.phi=Math.acos(ht(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var ip=class{static{this.prototype.isMatrix2=!0}constructor(e,t,n,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let n=0;n<4;n++)this.elements[n]=e[n+t];return this}set(e,t,n,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=n,r[3]=s,this}};var ml=class extends gi{constructor(e=10,t=10,n=4473924,s=8947848){n=new it(n),s=new it(s);let r=t/2,o=e/t,a=e/2,l=[],c=[];for(let d=0,f=0,p=-a;d<=t;d++,p+=o){l.push(-a,0,p,a,0,p),l.push(p,0,-a,p,0,a);let _=d===r?n:s;_.toArray(c,f),f+=3,_.toArray(c,f),f+=3,_.toArray(c,f),f+=3,_.toArray(c,f),f+=3}let h=new Nt;h.setAttribute("position",new ut(l,3)),h.setAttribute("color",new ut(c,3));let u=new _n({vertexColors:!0,toneMapped:!1});super(h,u),this.type="GridHelper"}dispose(){super.dispose(),this.geometry.dispose(),this.material.dispose()}};var wy=new I,lh,Zf,Is=class extends wn{constructor(e=new I(0,0,1),t=new I(0,0,0),n=1,s=16776960,r=n*.2,o=r*.2){super(),this.type="ArrowHelper",lh===void 0&&(lh=new Nt,lh.setAttribute("position",new ut([0,0,0,0,1,0],3)),Zf=new Go(.5,1,5,1),Zf.translate(0,-.5,0)),this.position.copy(t),this.line=new Ti(lh,new _n({color:s,toneMapped:!1})),this.line.matrixAutoUpdate=!1,this.add(this.line),this.cone=new Mt(Zf,new Rs({color:s,toneMapped:!1})),this.cone.matrixAutoUpdate=!1,this.add(this.cone),this.setDirection(e),this.setLength(n,r,o)}setDirection(e){if(e.y>.99999)this.quaternion.set(0,0,0,1);else if(e.y<-.99999)this.quaternion.set(1,0,0,0);else{wy.set(e.z,0,-e.x).normalize();let t=Math.acos(e.y);this.quaternion.setFromAxisAngle(wy,t)}}setLength(e,t=e*.2,n=t*.2){this.line.scale.set(1,Math.max(1e-4,e-t),1),this.line.updateMatrix(),this.cone.scale.set(n,t,n),this.cone.position.y=e,this.cone.updateMatrix()}setColor(e){this.line.material.color.set(e),this.cone.material.color.set(e)}copy(e){return super.copy(e,!1),this.line.copy(e.line),this.cone.copy(e.cone),this}dispose(){super.dispose(),this.line.geometry.dispose(),this.line.material.dispose(),this.cone.geometry.dispose(),this.cone.material.dispose()}};var gl=class extends Bi{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function Bp(i,e,t,n){let s=xE(n);switch(t){case Sp:return i*e;case wp:return i*e/s.components*s.byteLength;case ru:return i*e/s.components*s.byteLength;case hr:return i*e*2/s.components*s.byteLength;case ou:return i*e*2/s.components*s.byteLength;case Mp:return i*e*3/s.components*s.byteLength;case $i:return i*e*4/s.components*s.byteLength;case au:return i*e*4/s.components*s.byteLength;case xl:case vl:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case bl:case Sl:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case cu:case uu:return Math.max(i,16)*Math.max(e,8)/4;case lu:case hu:return Math.max(i,8)*Math.max(e,8)/2;case du:case fu:case mu:case gu:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case pu:case Ml:case _u:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case yu:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case xu:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case vu:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case bu:return Math.floor((i+5)/6)*Math.floor((e+4)/5)*16;case Su:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case Mu:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case wu:return Math.floor((i+7)/8)*Math.floor((e+5)/6)*16;case Eu:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case Tu:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case Au:return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case Cu:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case Ru:return Math.floor((i+9)/10)*Math.floor((e+9)/10)*16;case Pu:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case Iu:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case Lu:case Du:case Nu:return Math.ceil(i/4)*Math.ceil(e/4)*16;case Uu:case Ou:return Math.ceil(i/4)*Math.ceil(e/4)*8;case wl:case Fu:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function xE(i){switch(i){case ei:case yp:return{byteLength:1,components:1};case Yo:case xp:case Wi:return{byteLength:2,components:1};case iu:case su:return{byteLength:2,components:4};case Gi:case nu:case Hi:return{byteLength:4,components:1};case vp:case bp:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Ze("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Dx(){let i=null,e=!1,t=null,n=null;function s(r,o){n=i.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&i!==null&&(n=i.requestAnimationFrame(s),e=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){i=r}}}function bE(i){let e=new WeakMap;function t(a,l){let c=a.array,h=a.usage,u=c.byteLength,d=i.createBuffer();i.bindBuffer(l,d),i.bufferData(l,c,h),a.onUploadCallback();let f;if(c instanceof Float32Array)f=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=i.HALF_FLOAT:f=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=i.SHORT;else if(c instanceof Uint32Array)f=i.UNSIGNED_INT;else if(c instanceof Int32Array)f=i.INT;else if(c instanceof Int8Array)f=i.BYTE;else if(c instanceof Uint8Array)f=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:u}}function n(a,l,c){let h=l.array,u=l.updateRanges;if(i.bindBuffer(c,a),u.length===0)i.bufferSubData(c,0,h);else{u.sort((f,p)=>f.start-p.start);let d=0;for(let f=1;f<u.length;f++){let p=u[d],_=u[f];_.start<=p.start+p.count+1?p.count=Math.max(p.count,_.start+_.count-p.start):(++d,u[d]=_)}u.length=d+1;for(let f=0,p=u.length;f<p;f++){let _=u[f];i.bufferSubData(c,_.start*h.BYTES_PER_ELEMENT,h,_.start,_.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(i.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=e.get(a);(!h||h.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var SE=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,ME=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,wE=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,EE=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,TE=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,AE=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,CE=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,RE=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,PE=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,IE=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,LE=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,DE=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,NE=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,UE=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,OE=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,FE=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,kE=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,BE=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,zE=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,VE=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,GE=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,HE=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,WE=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,$E=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,qE=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,XE=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,YE=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,ZE=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,jE=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,JE="gl_FragColor = linearToOutputTexel( gl_FragColor );",KE=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,QE=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,eT=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,tT=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,nT=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,iT=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,sT=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,rT=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,oT=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,aT=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,lT=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,cT=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,hT=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,uT=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,dT=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,fT=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,pT=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,mT=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,gT=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,_T=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,yT=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,xT=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,vT=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,bT=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,ST=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,MT=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,wT=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,ET=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,TT=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,AT=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,CT=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,RT=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,PT=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,IT=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,LT=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,DT=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,NT=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,UT=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,OT=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,FT=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,kT=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,BT=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,zT=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,VT=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,GT=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,HT=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,WT=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,$T=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,qT=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,XT=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,YT=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,ZT=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,jT=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,JT=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,KT=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,QT=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,eA=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,tA=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,nA=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,iA=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,sA=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,rA=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,oA=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,aA=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,lA=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,cA=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,hA=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,uA=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,dA=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,fA=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,pA=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,mA=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,gA=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,_A=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,yA=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,xA=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,vA=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,bA=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,SA=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,MA=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,wA=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,EA=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,TA=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,AA=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,CA=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,RA=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,PA=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,IA=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,LA=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,DA=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,NA=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,UA=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,OA=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,FA=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,kA=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,BA=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,zA=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,VA=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,GA=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,HA=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,WA=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,$A=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,qA=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,XA=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,YA=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,ZA=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,jA=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,JA=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,KA=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,QA=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,e1=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,pt={alphahash_fragment:SE,alphahash_pars_fragment:ME,alphamap_fragment:wE,alphamap_pars_fragment:EE,alphatest_fragment:TE,alphatest_pars_fragment:AE,aomap_fragment:CE,aomap_pars_fragment:RE,batching_pars_vertex:PE,batching_vertex:IE,begin_vertex:LE,beginnormal_vertex:DE,bsdfs:NE,iridescence_fragment:UE,bumpmap_pars_fragment:OE,clipping_planes_fragment:FE,clipping_planes_pars_fragment:kE,clipping_planes_pars_vertex:BE,clipping_planes_vertex:zE,color_fragment:VE,color_pars_fragment:GE,color_pars_vertex:HE,color_vertex:WE,common:$E,defaultnormal_vertex:qE,displacementmap_pars_vertex:XE,displacementmap_vertex:YE,emissivemap_fragment:ZE,emissivemap_pars_fragment:jE,colorspace_fragment:JE,colorspace_pars_fragment:KE,envmap_fragment:QE,envmap_common_pars_fragment:eT,envmap_pars_fragment:tT,envmap_pars_vertex:nT,envmap_physical_pars_fragment:fT,envmap_vertex:iT,fog_vertex:sT,fog_pars_vertex:rT,fog_fragment:oT,fog_pars_fragment:aT,gradientmap_pars_fragment:lT,lightmap_pars_fragment:cT,lights_lambert_fragment:hT,lights_lambert_pars_fragment:uT,lights_pars_begin:dT,lights_toon_fragment:pT,lights_toon_pars_fragment:mT,lights_phong_fragment:gT,lights_phong_pars_fragment:_T,lights_physical_fragment:yT,lights_physical_pars_fragment:xT,lights_fragment_begin:vT,lights_fragment_maps:bT,lights_fragment_end:ST,lightprobes_pars_fragment:MT,logdepthbuf_fragment:wT,logdepthbuf_pars_fragment:ET,logdepthbuf_pars_vertex:TT,logdepthbuf_vertex:AT,map_fragment:CT,map_pars_fragment:RT,map_particle_fragment:PT,map_particle_pars_fragment:IT,metalnessmap_fragment:LT,metalnessmap_pars_fragment:DT,morphinstance_vertex:NT,morphcolor_vertex:UT,morphnormal_vertex:OT,morphtarget_pars_vertex:FT,morphtarget_vertex:kT,normal_fragment_begin:BT,normal_fragment_maps:zT,normal_pars_fragment:VT,normal_pars_vertex:GT,normal_vertex:HT,normalmap_pars_fragment:WT,clearcoat_normal_fragment_begin:$T,clearcoat_normal_fragment_maps:qT,clearcoat_pars_fragment:XT,iridescence_pars_fragment:YT,opaque_fragment:ZT,packing:jT,premultiplied_alpha_fragment:JT,project_vertex:KT,dithering_fragment:QT,dithering_pars_fragment:eA,roughnessmap_fragment:tA,roughnessmap_pars_fragment:nA,shadowmap_pars_fragment:iA,shadowmap_pars_vertex:sA,shadowmap_vertex:rA,shadowmask_pars_fragment:oA,skinbase_vertex:aA,skinning_pars_vertex:lA,skinning_vertex:cA,skinnormal_vertex:hA,specularmap_fragment:uA,specularmap_pars_fragment:dA,tonemapping_fragment:fA,tonemapping_pars_fragment:pA,transmission_fragment:mA,transmission_pars_fragment:gA,uv_pars_fragment:_A,uv_pars_vertex:yA,uv_vertex:xA,worldpos_vertex:vA,background_vert:bA,background_frag:SA,backgroundCube_vert:MA,backgroundCube_frag:wA,cube_vert:EA,cube_frag:TA,depth_vert:AA,depth_frag:CA,distance_vert:RA,distance_frag:PA,equirect_vert:IA,equirect_frag:LA,linedashed_vert:DA,linedashed_frag:NA,meshbasic_vert:UA,meshbasic_frag:OA,meshlambert_vert:FA,meshlambert_frag:kA,meshmatcap_vert:BA,meshmatcap_frag:zA,meshnormal_vert:VA,meshnormal_frag:GA,meshphong_vert:HA,meshphong_frag:WA,meshphysical_vert:$A,meshphysical_frag:qA,meshtoon_vert:XA,meshtoon_frag:YA,points_vert:ZA,points_frag:jA,shadow_vert:JA,shadow_frag:KA,sprite_vert:QA,sprite_frag:e1},Ne={common:{diffuse:{value:new it(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new st},alphaMap:{value:null},alphaMapTransform:{value:new st},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new st}},envmap:{envMap:{value:null},envMapRotation:{value:new st},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new st}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new st}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new st},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new st},normalScale:{value:new Me(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new st},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new st}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new st}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new st}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new it(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new it(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new st},alphaTest:{value:0},uvTransform:{value:new st}},sprite:{diffuse:{value:new it(16777215)},opacity:{value:1},center:{value:new Me(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new st},alphaMap:{value:null},alphaMapTransform:{value:new st},alphaTest:{value:0}}},us={basic:{uniforms:Vn([Ne.common,Ne.specularmap,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.fog]),vertexShader:pt.meshbasic_vert,fragmentShader:pt.meshbasic_frag},lambert:{uniforms:Vn([Ne.common,Ne.specularmap,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.fog,Ne.lights,{emissive:{value:new it(0)},envMapIntensity:{value:1}}]),vertexShader:pt.meshlambert_vert,fragmentShader:pt.meshlambert_frag},phong:{uniforms:Vn([Ne.common,Ne.specularmap,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.fog,Ne.lights,{emissive:{value:new it(0)},specular:{value:new it(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:pt.meshphong_vert,fragmentShader:pt.meshphong_frag},standard:{uniforms:Vn([Ne.common,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.roughnessmap,Ne.metalnessmap,Ne.fog,Ne.lights,{emissive:{value:new it(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:pt.meshphysical_vert,fragmentShader:pt.meshphysical_frag},toon:{uniforms:Vn([Ne.common,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.gradientmap,Ne.fog,Ne.lights,{emissive:{value:new it(0)}}]),vertexShader:pt.meshtoon_vert,fragmentShader:pt.meshtoon_frag},matcap:{uniforms:Vn([Ne.common,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.fog,{matcap:{value:null}}]),vertexShader:pt.meshmatcap_vert,fragmentShader:pt.meshmatcap_frag},points:{uniforms:Vn([Ne.points,Ne.fog]),vertexShader:pt.points_vert,fragmentShader:pt.points_frag},dashed:{uniforms:Vn([Ne.common,Ne.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:pt.linedashed_vert,fragmentShader:pt.linedashed_frag},depth:{uniforms:Vn([Ne.common,Ne.displacementmap]),vertexShader:pt.depth_vert,fragmentShader:pt.depth_frag},normal:{uniforms:Vn([Ne.common,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,{opacity:{value:1}}]),vertexShader:pt.meshnormal_vert,fragmentShader:pt.meshnormal_frag},sprite:{uniforms:Vn([Ne.sprite,Ne.fog]),vertexShader:pt.sprite_vert,fragmentShader:pt.sprite_frag},background:{uniforms:{uvTransform:{value:new st},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:pt.background_vert,fragmentShader:pt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new st}},vertexShader:pt.backgroundCube_vert,fragmentShader:pt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:pt.cube_vert,fragmentShader:pt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:pt.equirect_vert,fragmentShader:pt.equirect_frag},distance:{uniforms:Vn([Ne.common,Ne.displacementmap,{referencePosition:{value:new I},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:pt.distance_vert,fragmentShader:pt.distance_frag},shadow:{uniforms:Vn([Ne.lights,Ne.fog,{color:{value:new it(0)},opacity:{value:1}}]),vertexShader:pt.shadow_vert,fragmentShader:pt.shadow_frag}};us.physical={uniforms:Vn([us.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new st},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new st},clearcoatNormalScale:{value:new Me(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new st},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new st},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new st},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new st},sheen:{value:0},sheenColor:{value:new it(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new st},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new st},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new st},transmissionSamplerSize:{value:new Me},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new st},attenuationDistance:{value:0},attenuationColor:{value:new it(0)},specularColor:{value:new it(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new st},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new st},anisotropyVector:{value:new Me},anisotropyMap:{value:null},anisotropyMapTransform:{value:new st}}]),vertexShader:pt.meshphysical_vert,fragmentShader:pt.meshphysical_frag};var Bu={r:0,b:0,g:0},t1=new St,Nx=new st;Nx.set(-1,0,0,0,1,0,0,0,1);function n1(i,e,t,n,s,r){let o=new it(0),a=s===!0?0:1,l,c,h=null,u=0,d=null;function f(y){let T=y.isScene===!0?y.background:null;if(T&&T.isTexture){let b=y.backgroundBlurriness>0;T=e.get(T,b)}return T}function p(y){let T=!1,b=f(y);b===null?m(o,a):b&&b.isColor&&(m(b,1),T=!0);let C=i.xr.getEnvironmentBlendMode();C==="additive"?t.buffers.color.setClear(0,0,0,1,r):C==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(i.autoClear||T)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function _(y,T){let b=f(T);b&&b.isCubeTexture?(c===void 0&&(c=new Mt(new Vi(1,1,1),new ls({name:"BackgroundCubeMaterial",uniforms:Br(us.backgroundCube.uniforms),vertexShader:us.backgroundCube.vertexShader,fragmentShader:us.backgroundCube.fragmentShader,side:Kn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(C,A,x){this.matrixWorld.copyPosition(x.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=b,c.material.uniforms.backgroundBlurriness.value=T.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=T.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(t1.makeRotationFromEuler(T.backgroundRotation)).transpose(),b.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Nx),c.material.toneMapped=bt.getTransfer(b.colorSpace)!==Dt,(h!==b||u!==b.version||d!==i.toneMapping)&&(c.material.needsUpdate=!0,h=b,u=b.version,d=i.toneMapping),c.layers.enableAll(),y.unshift(c,c.geometry,c.material,0,0,null)):b&&b.isTexture&&(l===void 0&&(l=new Mt(new sl(2,2),new ls({name:"BackgroundMaterial",uniforms:Br(us.background.uniforms),vertexShader:us.background.vertexShader,fragmentShader:us.background.fragmentShader,side:cr,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=b,l.material.uniforms.backgroundIntensity.value=T.backgroundIntensity,l.material.toneMapped=bt.getTransfer(b.colorSpace)!==Dt,b.matrixAutoUpdate===!0&&b.updateMatrix(),l.material.uniforms.uvTransform.value.copy(b.matrix),(h!==b||u!==b.version||d!==i.toneMapping)&&(l.material.needsUpdate=!0,h=b,u=b.version,d=i.toneMapping),l.layers.enableAll(),y.unshift(l,l.geometry,l.material,0,0,null))}function m(y,T){y.getRGB(Bu,Op(i)),t.buffers.color.setClear(Bu.r,Bu.g,Bu.b,T,r)}function g(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(y,T=1){o.set(y),a=T,m(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(y){a=y,m(o,a)},render:p,addToRenderList:_,dispose:g}}function i1(i,e){let t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=d(null),r=s,o=!1;function a(D,V,W,U,G){let Z=!1,z=u(D,U,W,V);r!==z&&(r=z,c(r.object)),Z=f(D,U,W,G),Z&&p(D,U,W,G),G!==null&&e.update(G,i.ELEMENT_ARRAY_BUFFER),(Z||o)&&(o=!1,b(D,V,W,U),G!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,e.get(G).buffer))}function l(){return i.createVertexArray()}function c(D){return i.bindVertexArray(D)}function h(D){return i.deleteVertexArray(D)}function u(D,V,W,U){let G=U.wireframe===!0,Z=n[V.id];Z===void 0&&(Z={},n[V.id]=Z);let z=D.isInstancedMesh===!0?D.id:0,ce=Z[z];ce===void 0&&(ce={},Z[z]=ce);let j=ce[W.id];j===void 0&&(j={},ce[W.id]=j);let K=j[G];return K===void 0&&(K=d(l()),j[G]=K),K}function d(D){let V=[],W=[],U=[];for(let G=0;G<t;G++)V[G]=0,W[G]=0,U[G]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:V,enabledAttributes:W,attributeDivisors:U,object:D,attributes:{},index:null}}function f(D,V,W,U){let G=r.attributes,Z=V.attributes,z=0,ce=W.getAttributes();for(let j in ce)if(ce[j].location>=0){let ie=G[j],de=Z[j];if(de===void 0&&(j==="instanceMatrix"&&D.instanceMatrix&&(de=D.instanceMatrix),j==="instanceColor"&&D.instanceColor&&(de=D.instanceColor)),ie===void 0||ie.attribute!==de||de&&ie.data!==de.data)return!0;z++}return r.attributesNum!==z||r.index!==U}function p(D,V,W,U){let G={},Z=V.attributes,z=0,ce=W.getAttributes();for(let j in ce)if(ce[j].location>=0){let ie=Z[j];ie===void 0&&(j==="instanceMatrix"&&D.instanceMatrix&&(ie=D.instanceMatrix),j==="instanceColor"&&D.instanceColor&&(ie=D.instanceColor));let de={};de.attribute=ie,ie&&ie.data&&(de.data=ie.data),G[j]=de,z++}r.attributes=G,r.attributesNum=z,r.index=U}function _(){let D=r.newAttributes;for(let V=0,W=D.length;V<W;V++)D[V]=0}function m(D){g(D,0)}function g(D,V){let W=r.newAttributes,U=r.enabledAttributes,G=r.attributeDivisors;W[D]=1,U[D]===0&&(i.enableVertexAttribArray(D),U[D]=1),G[D]!==V&&(i.vertexAttribDivisor(D,V),G[D]=V)}function y(){let D=r.newAttributes,V=r.enabledAttributes;for(let W=0,U=V.length;W<U;W++)V[W]!==D[W]&&(i.disableVertexAttribArray(W),V[W]=0)}function T(D,V,W,U,G,Z,z){z===!0?i.vertexAttribIPointer(D,V,W,G,Z):i.vertexAttribPointer(D,V,W,U,G,Z)}function b(D,V,W,U){_();let G=U.attributes,Z=W.getAttributes(),z=V.defaultAttributeValues;for(let ce in Z){let j=Z[ce];if(j.location>=0){let K=G[ce];if(K===void 0&&(ce==="instanceMatrix"&&D.instanceMatrix&&(K=D.instanceMatrix),ce==="instanceColor"&&D.instanceColor&&(K=D.instanceColor)),K!==void 0){let ie=K.normalized,de=K.itemSize,ue=e.get(K);if(ue===void 0)continue;let Q=ue.buffer,ge=ue.type,xe=ue.bytesPerElement,Re=ge===i.INT||ge===i.UNSIGNED_INT||K.gpuType===nu;if(K.isInterleavedBufferAttribute){let we=K.data,qe=we.isInterleavedBuffer===!0?we.stride:we.itemSize,at=K.offset;if(we.isInstancedInterleavedBuffer||we.isInstancedBufferAttribute){for(let We=0;We<j.locationSize;We++)g(j.location+We,we.meshPerAttribute);D.isInstancedMesh!==!0&&U._maxInstanceCount===void 0&&(U._maxInstanceCount=we.meshPerAttribute*we.count)}else for(let We=0;We<j.locationSize;We++)m(j.location+We);i.bindBuffer(i.ARRAY_BUFFER,Q);for(let We=0;We<j.locationSize;We++)T(j.location+We,de/j.locationSize,ge,ie,qe*xe,(at+de/j.locationSize*We)*xe,Re)}else{if(K.isInstancedBufferAttribute){for(let we=0;we<j.locationSize;we++)g(j.location+we,K.meshPerAttribute);D.isInstancedMesh!==!0&&U._maxInstanceCount===void 0&&(U._maxInstanceCount=K.meshPerAttribute*K.count)}else for(let we=0;we<j.locationSize;we++)m(j.location+we);i.bindBuffer(i.ARRAY_BUFFER,Q);for(let we=0;we<j.locationSize;we++)T(j.location+we,de/j.locationSize,ge,ie,de*xe,de/j.locationSize*we*xe,Re)}}else if(z!==void 0){let ie=z[ce];if(ie!==void 0)switch(ie.length){case 2:i.vertexAttrib2fv(j.location,ie);break;case 3:i.vertexAttrib3fv(j.location,ie);break;case 4:i.vertexAttrib4fv(j.location,ie);break;default:i.vertexAttrib1fv(j.location,ie)}}}}y()}function C(){k();for(let D in n){let V=n[D];for(let W in V){let U=V[W];for(let G in U){let Z=U[G];for(let z in Z)h(Z[z].object),delete Z[z];delete U[G]}}delete n[D]}}function A(D){if(n[D.id]===void 0)return;let V=n[D.id];for(let W in V){let U=V[W];for(let G in U){let Z=U[G];for(let z in Z)h(Z[z].object),delete Z[z];delete U[G]}}delete n[D.id]}function x(D){for(let V in n){let W=n[V];for(let U in W){let G=W[U];if(G[D.id]===void 0)continue;let Z=G[D.id];for(let z in Z)h(Z[z].object),delete Z[z];delete G[D.id]}}}function M(D){for(let V in n){let W=n[V],U=D.isInstancedMesh===!0?D.id:0,G=W[U];if(G!==void 0){for(let Z in G){let z=G[Z];for(let ce in z)h(z[ce].object),delete z[ce];delete G[Z]}delete W[U],Object.keys(W).length===0&&delete n[V]}}}function k(){N(),o=!0,r!==s&&(r=s,c(r.object))}function N(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:k,resetDefaultState:N,dispose:C,releaseStatesOfGeometry:A,releaseStatesOfObject:M,releaseStatesOfProgram:x,initAttributes:_,enableAttribute:m,disableUnusedAttributes:y}}function s1(i,e,t){let n;function s(l){n=l}function r(l,c){i.drawArrays(n,l,c),t.update(c,n,1)}function o(l,c,h){h!==0&&(i.drawArraysInstanced(n,l,c,h),t.update(c,n,h))}function a(l,c,h){if(h===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,h);let d=0;for(let f=0;f<h;f++)d+=c[f];t.update(d,n,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function r1(i,e,t,n){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let x=e.get("EXT_texture_filter_anisotropic");s=i.getParameter(x.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(x){return!(x!==$i&&n.convert(x)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(x){let M=x===Wi&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(x!==ei&&x!==Hi&&!M&&n.convert(x)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function l(x){if(x==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";x="mediump"}return x==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",h=l(c);h!==c&&(Ze("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let u=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),d=t.logarithmicDepthBuffer===!0&&u===!1;t.reversedDepthBuffer===!0&&u===!1&&Ze("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&u===!0&&Ze("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),p=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),_=i.getParameter(i.MAX_TEXTURE_SIZE),m=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),g=i.getParameter(i.MAX_VERTEX_ATTRIBS),y=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),T=i.getParameter(i.MAX_VARYING_VECTORS),b=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),C=i.getParameter(i.MAX_SAMPLES),A=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:u,maxTextures:f,maxVertexTextures:p,maxTextureSize:_,maxCubemapSize:m,maxAttributes:g,maxVertexUniforms:y,maxVaryings:T,maxFragmentUniforms:b,maxSamples:C,samples:A}}function o1(i){let e=this,t=null,n=0,s=!1,r=!1,o=new fi,a=new st,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,d){let f=u.length!==0||d||n!==0||s;return s=d,n=u.length,f},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,d){t=h(u,d,0)},this.setState=function(u,d,f){let p=u.clippingPlanes,_=u.clipIntersection,m=u.clipShadows,g=i.get(u);if(!s||p===null||p.length===0||r&&!m)r?h(null):c();else{let y=r?0:n,T=y*4,b=g.clippingState||null;l.value=b,b=h(p,d,T,f);for(let C=0;C!==T;++C)b[C]=t[C];g.clippingState=b,this.numIntersection=_?this.numPlanes:0,this.numPlanes+=y}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=n>0),e.numPlanes=n,e.numIntersection=0}function h(u,d,f,p){let _=u!==null?u.length:0,m=null;if(_!==0){if(m=l.value,p!==!0||m===null){let g=f+_*4,y=d.matrixWorldInverse;a.getNormalMatrix(y),(m===null||m.length<g)&&(m=new Float32Array(g));for(let T=0,b=f;T!==_;++T,b+=4)o.copy(u[T]).applyMatrix4(y,a),o.normal.toArray(m,b),m[b+3]=o.constant}l.value=m,l.needsUpdate=!0}return e.numPlanes=_,e.numIntersection=0,m}}var Cl=class extends mi{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let n={width:e,height:e,depth:1},s=[n,n,n,n,n,n];this.texture=new ja(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new Vi(5,5,5),r=new ls({name:"CubemapFromEquirect",uniforms:Br(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:Kn,blending:Ur});r.uniforms.tEquirect.value=t;let o=new Mt(s,r),a=t.minFilter;return t.minFilter===Ls&&(t.minFilter=jn),new Ho(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,n=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,n,s);e.setRenderTarget(r)}},dx=256,a1=3,l1=20,Ux=256,Ox=16,c1=3,h1=new I,u1=new it,Vu=class i{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Ho(1,10,null),this._boxMesh=new Mt(new Vi(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,n=.1,s=100,r={}){let{size:o=256,position:a=h1}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),h=this._getSourceTarget(!0);t>0&&(h.texture.mipmapsAutoUpdate=!1);let u=l.autoClear,d=l.autoClearColor,f=l.autoClearDepth,p=l.autoClearStencil,_=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,_===null&&(e.background=l.getClearColor(u1));let m=new Ho(n,s,h);return m.position.copy(a),m.update(l,e),l.autoClear=u,l.autoClearColor=d,l.autoClearDepth=f,l.autoClearStencil=p,e.background=_,t>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=mx(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=px(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(dx,Ip(e))}_fromTexture(e,t){e.mapping===Fr||e.mapping===Xo?this._setSize(e.image.length===0?dx:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let n=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(n),n}_allocateTarget(){let e=this._cubeSize,t=fx(e,!1,!1),n=Math.log2(e)-a1;for(let s=0;s<=n;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==t||e&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=fx(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===Fr||e.mapping===Xo?(this._cubemapMaterial===null&&(this._cubemapMaterial=mx()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=px()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=d1(),this._integrationMaterial=f1());let t=this._cubeSize,n=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/Ox);for(let o=0;o<=n;o++){let a=i.lodToRoughness(o,n);if(o>n-c1)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(Ux*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=p1());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,n),s.envMap.value=e.texture,this._renderCube(r,0,n)}};function fx(i,e,t){return new Cl(i,{minFilter:Ls,generateMipmaps:e,type:Wi,colorSpace:Va,depthBuffer:t})}function Rl(i,e,t){return new ls({name:i,uniforms:e,vertexShader:pt.cube_vert,fragmentShader:t,side:Kn,blending:Ur,depthTest:!1,depthWrite:!1})}function d1(){return Rl("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Ux}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function f1(){return Rl("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Ox}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function p1(){return Rl("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${l1}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function px(){return Rl("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function mx(){return Rl("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function m1(i){let e=new WeakMap,t=new WeakMap,n=null;function s(d,f=!1){return d==null?null:f?o(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===Qh||f===eu)if(e.has(d)){let p=e.get(d).texture;return a(p,d.mapping)}else{let p=d.image;if(p&&p.height>0){let _=new Cl(p.height);return _.fromEquirectangularTexture(i,d),e.set(d,_),d.addEventListener("dispose",c),a(_.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,p=f===Qh||f===eu,_=f===Fr||f===Xo;if(p||_){let m=t.get(d),g=m!==void 0?m.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==g)return n===null&&(n=new Vu(i)),m=p?n.fromEquirectangular(d,m):n.fromCubemap(d,m),m.texture.pmremVersion=d.pmremVersion,t.set(d,m),m.texture;if(m!==void 0)return m.texture;{let y=d.image;return p&&y&&y.height>0||_&&y&&l(y)?(n===null&&(n=new Vu(i)),m=p?n.fromEquirectangular(d):n.fromCubemap(d),m.texture.pmremVersion=d.pmremVersion,t.set(d,m),d.addEventListener("dispose",h),m.texture):null}}}return d}function a(d,f){return f===Qh?d.mapping=Fr:f===eu&&(d.mapping=Xo),d}function l(d){let f=0,p=6;for(let _=0;_<p;_++)d[_]!==void 0&&f++;return f===p}function c(d){let f=d.target;f.removeEventListener("dispose",c);let p=e.get(f);p!==void 0&&(e.delete(f),p.dispose())}function h(d){let f=d.target;f.removeEventListener("dispose",h);let p=t.get(f);p!==void 0&&(t.delete(f),p.dispose())}function u(){e=new WeakMap,t=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:u}}function g1(i){let e={};function t(n){if(e[n]!==void 0)return e[n];let s=i.getExtension(n);return e[n]=s,s}return{has:function(n){return t(n)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(n){let s=t(n);return s===null&&Oa("WebGLRenderer: "+n+" extension not supported."),s}}}function _1(i,e,t,n){let s={},r=new WeakMap,o=new FinalizationRegistry(p=>delete s[p]);function a(p){l(p.target)}function l(p){p.index!==null&&e.remove(p.index);for(let m in p.attributes)e.remove(p.attributes[m]);p.removeEventListener("dispose",a),delete s[p.id],o.unregister(p);let _=r.get(p);_&&(e.remove(_),r.delete(p)),n.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,t.memory.geometries--}function c(p,_){return s[_.id]!==void 0||(_.addEventListener("dispose",a),s[_.id]=new WeakRef(_),o.register(_,_.id,_),t.memory.geometries++),_}function h(p){let _=p.attributes;for(let m in _)e.update(_[m],i.ARRAY_BUFFER)}function u(p){let _=p.index,m=p.attributes.position,g=0;if(m===void 0)return;let y=_!==null?_.array.length:m.array.length/3-1,T=m.count>=65535?Xa:qa,b=new T(Math.ceil(y/3)*6,1),C=b.array;if(_!==null){let x=_.array;g=_.version;for(let M=0,k=0;M<y;M+=3){let N=x[M+0],D=x[M+1],V=x[M+2];C[k++]=N,C[k++]=D,C[k++]=D,C[k++]=V,C[k++]=V,C[k++]=N}}else{g=m.version;for(let x=0,M=0;x<y;x+=3){let k=x+0,N=x+1,D=x+2;C[M++]=k,C[M++]=N,C[M++]=N,C[M++]=D,C[M++]=D,C[M++]=k}}b.version=g;let A=r.get(p);A&&e.remove(A),r.set(p,b)}function d(p){let _=r.get(p);if(_){let m=p.index;m!==null&&_.version<m.version&&u(p)}else u(p);return r.get(p)}function f(){for(let p in s){let _=s[p].deref();_!==void 0&&l(_)}}return{get:c,update:h,getWireframeAttribute:d,dispose:f}}function y1(i,e,t){let n;function s(u){n=u}let r,o;function a(u){r=u.type,o=u.bytesPerElement}function l(u,d){i.drawElements(n,d,r,u*o),t.update(d,n,1)}function c(u,d,f){f!==0&&(i.drawElementsInstanced(n,d,r,u*o,f),t.update(d,n,f))}function h(u,d,f){if(f===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,d,0,r,u,0,f);let _=0;for(let m=0;m<f;m++)_+=d[m];t.update(_,n,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function x1(i){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(t.calls++,o){case i.TRIANGLES:t.triangles+=a*(r/3);break;case i.LINES:t.lines+=a*(r/2);break;case i.LINE_STRIP:t.lines+=a*(r-1);break;case i.LINE_LOOP:t.lines+=a*r;break;case i.POINTS:t.points+=a*r;break;default:Qe("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:n}}function v1(i,e,t){let n=new WeakMap,s=new Kt;function r(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=h!==void 0?h.length:0,d=n.get(a);if(d===void 0||d.count!==u){let N=function(){M.dispose(),n.delete(a),a.removeEventListener("dispose",N)};var f=N;d!==void 0&&d.texture.dispose();let p=a.morphAttributes.position!==void 0,_=a.morphAttributes.normal!==void 0,m=a.morphAttributes.color!==void 0,g=a.morphAttributes.position||[],y=a.morphAttributes.normal||[],T=a.morphAttributes.color||[],b=0;p===!0&&(b=1),_===!0&&(b=2),m===!0&&(b=3);let C=a.attributes.position.count*b,A=1;C>e.maxTextureSize&&(A=Math.ceil(C/e.maxTextureSize),C=e.maxTextureSize);let x=new Float32Array(C*A*4*u),M=new $a(x,C,A,u);M.type=Hi,M.needsUpdate=!0;let k=b*4;for(let D=0;D<u;D++){let V=g[D],W=y[D],U=T[D],G=C*A*4*D;for(let Z=0;Z<V.count;Z++){let z=Z*k;p===!0&&(s.fromBufferAttribute(V,Z),x[G+z+0]=s.x,x[G+z+1]=s.y,x[G+z+2]=s.z,x[G+z+3]=0),_===!0&&(s.fromBufferAttribute(W,Z),x[G+z+4]=s.x,x[G+z+5]=s.y,x[G+z+6]=s.z,x[G+z+7]=0),m===!0&&(s.fromBufferAttribute(U,Z),x[G+z+8]=s.x,x[G+z+9]=s.y,x[G+z+10]=s.z,x[G+z+11]=U.itemSize===4?s.w:1)}}d={count:u,texture:M,size:new Me(C,A)},n.set(a,d),a.addEventListener("dispose",N)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,t);else{let p=0;for(let m=0;m<c.length;m++)p+=c[m];let _=a.morphTargetsRelative?1:1-p;l.getUniforms().setValue(i,"morphTargetBaseInfluence",_),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",d.texture,t),l.getUniforms().setValue(i,"morphTargetsTextureSize",d.size)}return{update:r}}function b1(i,e,t,n,s){let r=new WeakMap;function o(c){let h=s.render.frame,u=c.geometry,d=e.get(c,u);if(r.get(d)!==h&&(e.update(d),r.set(d,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(t.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,i.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==h&&(f.update(),r.set(f,h))}return d}function a(){r=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),n.releaseStatesOfObject(h),t.remove(h.instanceMatrix),h.instanceColor!==null&&t.remove(h.instanceColor)}return{update:o,dispose:a}}var S1={[hp]:"LINEAR_TONE_MAPPING",[up]:"REINHARD_TONE_MAPPING",[dp]:"CINEON_TONE_MAPPING",[fp]:"ACES_FILMIC_TONE_MAPPING",[mp]:"AGX_TONE_MAPPING",[gp]:"NEUTRAL_TONE_MAPPING",[pp]:"CUSTOM_TONE_MAPPING"};function M1(i,e,t,n,s,r){let o=new mi(e,t,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,h=new Nt;h.setAttribute("position",new ut([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new ut([0,2,0,0,2,0],2));let u=new Fh({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),d=new Mt(h,u),f=new Nr(-1,1,1,-1,0,1),p=null,_=null,m=!1,g,y=null,T=[],b=!1;this.setSize=function(C,A){o.setSize(C,A),a!==null&&a.setSize(C,A),l!==null&&l.setSize(C,A);for(let x=0;x<T.length;x++){let M=T[x];M.setSize&&M.setSize(C,A)}},this.setEffects=function(C){T=C,b=T.length>0&&T[0].isRenderPass===!0;let A=o.width,x=o.height;T.length>0&&a===null&&(a=new mi(A,x,{type:Wi,depthBuffer:!1,stencilBuffer:!1}),l=new mi(A,x,{type:Wi,depthBuffer:!1,stencilBuffer:!1}));let M=s===!0&&T.some(k=>k.needsDepthTexture===!0);M!==(o.depthTexture!==null)&&(M===!0&&c===null&&(c=new Ps(A,x),r===!0&&(c.format=Ds,c.type=kr)),o.dispose(),o.depthTexture=M?c:null,o.resolveDepthBuffer=M,o.storeMultisampledDepthBuffer=M);for(let k=0;k<T.length;k++){let N=T[k];N.setSize&&N.setSize(A,x),M&&N.needsDepthTexture===!0&&N.setDepthTexture&&N.setDepthTexture(c)}},this.begin=function(C,A){if(m||C.toneMapping===cs&&T.length===0)return!1;if(y=A,A!==null){let x=A.width,M=A.height;(o.width!==x||o.height!==M)&&this.setSize(x,M)}return b===!1&&C.setRenderTarget(o),g=C.toneMapping,C.toneMapping=cs,!0},this.hasRenderPass=function(){return b},this.end=function(C,A){C.toneMapping=g,m=!0;let x=o,M=a;for(let k=0;k<T.length;k++){let N=T[k];N.enabled!==!1&&(N.render(C,M,x,A),N.needsSwap!==!1&&(x=M,M=M===a?l:a))}if(p!==C.outputColorSpace||_!==C.toneMapping){p=C.outputColorSpace,_=C.toneMapping,u.defines={},bt.getTransfer(p)===Dt&&(u.defines.SRGB_TRANSFER="");let k=S1[_];k&&(u.defines[k]=""),u.needsUpdate=!0}u.uniforms.tDiffuse.value=x.texture,C.setRenderTarget(y),C.render(d,f),y=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),h.dispose(),u.dispose()}}var Fx=new Jn,kx=new Ps(1,1),Bx=new Ka(1),zx=new $a,Vx=new Mh,Gx=new ja,gx=[],_x=[],yx=new Float32Array(16),xx=new Float32Array(9),vx=new Float32Array(4);function jo(i,e,t){let n=i[0];if(n<=0||n>0)return i;let s=e*t,r=gx[s];if(r===void 0&&(r=new Float32Array(s),gx[s]=r),e!==0){n.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,i[o].toArray(r,a)}return r}function En(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}function Tn(i,e){for(let t=0,n=e.length;t<n;t++)i[t]=e[t]}function Hu(i,e){let t=_x[e];t===void 0&&(t=new Int32Array(e),_x[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}function w1(i,e){let t=this.cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}function E1(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(En(t,e))return;i.uniform2fv(this.addr,e),Tn(t,e)}}function T1(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(En(t,e))return;i.uniform3fv(this.addr,e),Tn(t,e)}}function A1(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(En(t,e))return;i.uniform4fv(this.addr,e),Tn(t,e)}}function C1(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(En(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),Tn(t,e)}else{if(En(t,n))return;vx.set(n),i.uniformMatrix2fv(this.addr,!1,vx),Tn(t,n)}}function R1(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(En(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),Tn(t,e)}else{if(En(t,n))return;xx.set(n),i.uniformMatrix3fv(this.addr,!1,xx),Tn(t,n)}}function P1(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(En(t,e))return;i.uniformMatrix4fv(this.addr,!1,e),Tn(t,e)}else{if(En(t,n))return;yx.set(n),i.uniformMatrix4fv(this.addr,!1,yx),Tn(t,n)}}function I1(i,e){let t=this.cache;t[0]!==e&&(i.uniform1i(this.addr,e),t[0]=e)}function L1(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(En(t,e))return;i.uniform2iv(this.addr,e),Tn(t,e)}}function D1(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(En(t,e))return;i.uniform3iv(this.addr,e),Tn(t,e)}}function N1(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(En(t,e))return;i.uniform4iv(this.addr,e),Tn(t,e)}}function U1(i,e){let t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}function O1(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(En(t,e))return;i.uniform2uiv(this.addr,e),Tn(t,e)}}function F1(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(En(t,e))return;i.uniform3uiv(this.addr,e),Tn(t,e)}}function k1(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(En(t,e))return;i.uniform4uiv(this.addr,e),Tn(t,e)}}function Wu(i){return i.version===0&&(i.compareFunction=Ap,i.needsUpdate=!0),i}function B1(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=Wu(kx):r=Fx,t.setTexture2D(e||r,s)}function z1(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture3D(e||Vx,s)}function V1(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=Wu(Bx):r=Gx,t.setTextureCube(e||r,s)}function G1(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture2DArray(e||zx,s)}function H1(i){switch(i){case 5126:return w1;case 35664:return E1;case 35665:return T1;case 35666:return A1;case 35674:return C1;case 35675:return R1;case 35676:return P1;case 5124:case 35670:return I1;case 35667:case 35671:return L1;case 35668:case 35672:return D1;case 35669:case 35673:return N1;case 5125:return U1;case 36294:return O1;case 36295:return F1;case 36296:return k1;case 35678:case 36198:case 36298:case 36306:case 35682:return B1;case 35679:case 36299:case 36307:return z1;case 35680:case 36300:case 36308:case 36293:return V1;case 36289:case 36303:case 36311:case 36292:return G1}}function W1(i,e){i.uniform1fv(this.addr,e)}function $1(i,e){let t=jo(e,this.size,2);i.uniform2fv(this.addr,t)}function q1(i,e){let t=jo(e,this.size,3);i.uniform3fv(this.addr,t)}function X1(i,e){let t=jo(e,this.size,4);i.uniform4fv(this.addr,t)}function Y1(i,e){let t=jo(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}function Z1(i,e){let t=jo(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}function j1(i,e){let t=jo(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}function J1(i,e){i.uniform1iv(this.addr,e)}function K1(i,e){i.uniform2iv(this.addr,e)}function Q1(i,e){i.uniform3iv(this.addr,e)}function eC(i,e){i.uniform4iv(this.addr,e)}function tC(i,e){i.uniform1uiv(this.addr,e)}function nC(i,e){i.uniform2uiv(this.addr,e)}function iC(i,e){i.uniform3uiv(this.addr,e)}function sC(i,e){i.uniform4uiv(this.addr,e)}function rC(i,e,t){let n=this.cache,s=e.length,r=Hu(t,s);En(n,r)||(i.uniform1iv(this.addr,r),Tn(n,r));let o;this.type===i.SAMPLER_2D_SHADOW?o=Wu(kx):o=Fx;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function oC(i,e,t){let n=this.cache,s=e.length,r=Hu(t,s);En(n,r)||(i.uniform1iv(this.addr,r),Tn(n,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||Vx,r[o])}function aC(i,e,t){let n=this.cache,s=e.length,r=Hu(t,s);En(n,r)||(i.uniform1iv(this.addr,r),Tn(n,r));let o;this.type===i.SAMPLER_CUBE_SHADOW?o=Wu(Bx):o=Gx;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function lC(i,e,t){let n=this.cache,s=e.length,r=Hu(t,s);En(n,r)||(i.uniform1iv(this.addr,r),Tn(n,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||zx,r[o])}function cC(i){switch(i){case 5126:return W1;case 35664:return $1;case 35665:return q1;case 35666:return X1;case 35674:return Y1;case 35675:return Z1;case 35676:return j1;case 5124:case 35670:return J1;case 35667:case 35671:return K1;case 35668:case 35672:return Q1;case 35669:case 35673:return eC;case 5125:return tC;case 36294:return nC;case 36295:return iC;case 36296:return sC;case 35678:case 36198:case 36298:case 36306:case 35682:return rC;case 35679:case 36299:case 36307:return oC;case 35680:case 36300:case 36308:case 36293:return aC;case 36289:case 36303:case 36311:case 36292:return lC}}var Gp=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=H1(t.type)}},Hp=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=cC(t.type)}},Wp=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],n)}}},zp=/(\w+)(\])?(\[|\.)?/g;function bx(i,e){i.seq.push(e),i.map[e.id]=e}function hC(i,e,t){let n=i.name,s=n.length;for(zp.lastIndex=0;;){let r=zp.exec(n),o=zp.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){bx(t,c===void 0?new Gp(a,i,e):new Hp(a,i,e));break}else{let u=t.map[a];u===void 0&&(u=new Wp(a),bx(t,u)),t=u}}}var Zo=class{constructor(e,t){this.seq=[],this.map={};let n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);hC(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,n,s){let r=this.map[t];r!==void 0&&r.setValue(e,n,s)}setOptional(e,t,n){let s=t[n];s!==void 0&&this.setValue(e,n,s)}static upload(e,t,n,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let n=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&n.push(o)}return n}};function Sx(i,e,t){let n=i.createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}var uC=37297,dC=0;function fC(i,e){let t=i.split(`
`),n=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return n.join(`
`)}var Mx=new st;function pC(i){bt._getMatrix(Mx,bt.workingColorSpace,i);let e=`mat3( ${Mx.elements.map(t=>t.toFixed(4))} )`;switch(bt.getTransfer(i)){case Ga:return[e,"LinearTransferOETF"];case Dt:return[e,"sRGBTransferOETF"];default:return Ze("WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}function wx(i,e,t){let n=i.getShaderParameter(e,i.COMPILE_STATUS),r=(i.getShaderInfoLog(e)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+fC(i.getShaderSource(e),a)}else return r}function mC(i,e){let t=pC(e);return[`vec4 ${i}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var gC={[hp]:"Linear",[up]:"Reinhard",[dp]:"Cineon",[fp]:"ACESFilmic",[mp]:"AgX",[gp]:"Neutral",[pp]:"Custom"};function _C(i,e){let t=gC[e];return t===void 0?(Ze("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var zu=new I;function yC(){bt.getLuminanceCoefficients(zu);let i=zu.x.toFixed(4),e=zu.y.toFixed(4),t=zu.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function xC(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Al).join(`
`)}function vC(i){let e=[];for(let t in i){let n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.join(`
`)}function bC(i,e){let t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(e,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:i.getAttribLocation(e,o),locationSize:a}}return t}function Al(i){return i!==""}function Ex(i,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function Tx(i,e){return i.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var SC=/^[ \t]*#include +<([\w\d./]+)>/gm;function $p(i){return i.replace(SC,MC)}function MC(i,e){let t=pt[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return $p(t)}var wC=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Ax(i){return i.replace(wC,EC)}function EC(i,e,t,n){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Cx(i){let e=`precision ${i.precision} float;
	precision ${i.precision} int;
	precision ${i.precision} sampler2D;
	precision ${i.precision} samplerCube;
	precision ${i.precision} sampler3D;
	precision ${i.precision} sampler2DArray;
	precision ${i.precision} sampler2DShadow;
	precision ${i.precision} samplerCubeShadow;
	precision ${i.precision} sampler2DArrayShadow;
	precision ${i.precision} isampler2D;
	precision ${i.precision} isampler3D;
	precision ${i.precision} isamplerCube;
	precision ${i.precision} isampler2DArray;
	precision ${i.precision} usampler2D;
	precision ${i.precision} usampler3D;
	precision ${i.precision} usamplerCube;
	precision ${i.precision} usampler2DArray;
	`;return i.precision==="highp"?e+=`
#define HIGH_PRECISION`:i.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}var TC={[_l]:"SHADOWMAP_TYPE_PCF",[$o]:"SHADOWMAP_TYPE_VSM"};function AC(i){return TC[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var CC={[Xo]:"ENVMAP_MODE_REFRACTION"};function RC(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":CC[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var PC={[Kh]:"ENVMAP_BLENDING_MULTIPLY",[qy]:"ENVMAP_BLENDING_MIX",[Xy]:"ENVMAP_BLENDING_ADD"};function IC(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":PC[i.combine]||"ENVMAP_BLENDING_NONE"}function LC(i,e,t,n){let s=i.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=AC(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=RC(t),u=IC(t),d=xC(t),f=vC(r),p=s.createProgram(),_,m,g=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(_=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(Al).join(`
`),_.length>0&&(_+=`
`),m=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(Al).join(`
`),m.length>0&&(m+=`
`)):(_=[Cx(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+h:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Al).join(`
`),m=[Cx(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+h:"",t.envMap?"#define "+u:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==cs?"#define TONE_MAPPING":"",t.toneMapping!==cs?pt.tonemapping_pars_fragment:"",t.toneMapping!==cs?_C("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",pt.colorspace_pars_fragment,mC("linearToOutputTexel",t.outputColorSpace),yC(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(Al).join(`
`)),o=$p(o),o=Ex(o,t),o=Tx(o,t),a=$p(a),a=Ex(a,t),a=Tx(a,t),o=Ax(o),a=Ax(a),t.isRawShaderMaterial!==!0&&(g=`#version 300 es
`,_=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+_,m=["#define varying in",t.glslVersion===Rp?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===Rp?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let y=g+_+o,T=g+m+a,b=Sx(s,s.VERTEX_SHADER,y),C=Sx(s,s.FRAGMENT_SHADER,T);s.attachShader(p,b),s.attachShader(p,C),t.index0AttributeName!==void 0?s.bindAttribLocation(p,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(p,0,"position"),s.linkProgram(p);function A(N){if(i.debug.checkShaderErrors){let D=s.getProgramInfoLog(p)||"",V=s.getShaderInfoLog(b)||"",W=s.getShaderInfoLog(C)||"",U=D.trim(),G=V.trim(),Z=W.trim(),z=!0,ce=!0;if(s.getProgramParameter(p,s.LINK_STATUS)===!1)if(z=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,p,b,C);else{let j=wx(s,b,"vertex"),K=wx(s,C,"fragment");Qe("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(p,s.VALIDATE_STATUS)+`

Material Name: `+N.name+`
Material Type: `+N.type+`

Program Info Log: `+U+`
`+j+`
`+K)}else U!==""?Ze("WebGLProgram: Program Info Log:",U):(G===""||Z==="")&&(ce=!1);ce&&(N.diagnostics={runnable:z,programLog:U,vertexShader:{log:G,prefix:_},fragmentShader:{log:Z,prefix:m}})}s.deleteShader(b),s.deleteShader(C),x=new Zo(s,p),M=bC(s,p)}let x;this.getUniforms=function(){return x===void 0&&A(this),x};let M;this.getAttributes=function(){return M===void 0&&A(this),M};let k=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return k===!1&&(k=s.getProgramParameter(p,uC)),k},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(p),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=dC++,this.cacheKey=e,this.usedTimes=1,this.program=p,this.vertexShader=b,this.fragmentShader=C,this}var DC=0,qp=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,n){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let n of t)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){let t=this.shaderCache,n=t.get(e);return n===void 0&&(n=new Xp(e),t.set(e,n)),n}},Xp=class{constructor(e){this.id=DC++,this.code=e,this.usedTimes=0}};function NC(i){return i===hr||i===Ml||i===wl}function UC(i,e,t,n,s,r){let o=new ko,a=new qp,l=new Set,c=[],h=new Map,u=n.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(x){return l.add(x),x===0?"uv":`uv${x}`}function p(x,M,k,N,D,V){let W=N.fog,U=D.geometry,G=x.isMeshStandardMaterial||x.isMeshLambertMaterial||x.isMeshPhongMaterial?N.environment:null,Z=x.isMeshStandardMaterial||x.isMeshLambertMaterial&&!x.envMap||x.isMeshPhongMaterial&&!x.envMap,z=e.get(x.envMap||G,Z),ce=d[x.type],j=n.precision;x.precision!==null&&(j=n.getMaxPrecision(x.precision),j!==x.precision&&Ze("WebGLProgram.getParameters:",x.precision,"not supported, using",j,"instead."));let K=U.morphAttributes.position||U.morphAttributes.normal||U.morphAttributes.color,ie=K!==void 0?K.length:0,de=0;U.morphAttributes.position!==void 0&&(de=1),U.morphAttributes.normal!==void 0&&(de=2),U.morphAttributes.color!==void 0&&(de=3);let ue,Q,ge,xe;if(ce){let Pe=us[ce];ue=Pe.vertexShader,Q=Pe.fragmentShader}else{ue=x.vertexShader,Q=x.fragmentShader;let Pe=a.getVertexShaderStage(x),ct=a.getFragmentShaderStage(x);a.update(x,Pe,ct),ge=Pe.id,xe=ct.id}let Re=i.getRenderTarget(),we=i.state.buffers.depth.getReversed(),qe=D.isInstancedMesh===!0,at=D.isBatchedMesh===!0,We=!!x.map,mt=!!x.matcap,dt=!!z,rt=dt&&z.isPMREMTexture===!0,jt=!!x.aoMap,Ht=!!x.lightMap,cn=!!x.bumpMap&&x.wireframe===!1,kt=!!x.normalMap,Cn=!!x.displacementMap,wt=!!x.emissiveMap,yn=!!x.metalnessMap,en=!!x.roughnessMap,hn=x.anisotropy>0,F=x.clearcoat>0,Ie=x.diffuseRoughness>0,Je=x.dispersion>0,lt=x.retroreflectivity>0,Ee=x.iridescence>0,zt=x.sheen>0,He=x.transmission>0,Ye=hn&&!!x.anisotropyMap,R=F&&!!x.clearcoatMap,S=F&&!!x.clearcoatNormalMap,$=F&&!!x.clearcoatRoughnessMap,he=Ie&&!!x.diffuseRoughnessMap,re=Ee&&!!x.iridescenceMap,ye=Ee&&!!x.iridescenceThicknessMap,ve=zt&&!!x.sheenColorMap,ee=zt&&!!x.sheenRoughnessMap,ne=!!x.specularMap,pe=!!x.specularColorMap,O=!!x.specularIntensityMap,se=He&&!!x.transmissionMap,te=He&&!!x.thicknessMap,Te=!!x.gradientMap,_e=!!x.alphaMap,Se=x.alphaTest>0,$e=!!x.alphaHash,et=!!x.extensions,le=cs;x.toneMapped&&(Re===null||Re.isXRRenderTarget===!0)&&(le=i.toneMapping);let ze=rt?z.isCompressedCubeTexture?z.image[0].mipmaps:z.mipmaps:null,tt={shaderID:ce,shaderType:x.type,shaderName:x.name,vertexShader:ue,fragmentShader:Q,defines:x.defines,customVertexShaderID:ge,customFragmentShaderID:xe,isRawShaderMaterial:x.isRawShaderMaterial===!0,glslVersion:x.glslVersion,precision:j,batching:at,batchingColor:at&&D._colorsTexture!==null,instancing:qe,instancingColor:qe&&D.instanceColor!==null,instancingMorph:qe&&D.morphTexture!==null,outputColorSpace:Re===null?i.outputColorSpace:Re.isXRRenderTarget===!0?Re.texture.colorSpace:bt.workingColorSpace,alphaToCoverage:!!x.alphaToCoverage,map:We,matcap:mt,envMap:dt,envMapMode:dt&&z.mapping,envMapPMREM:rt,envMapMaxLod:rt?ze.length-1:null,envMapSize:rt?ze[0].width:null,aoMap:jt,lightMap:Ht,bumpMap:cn,normalMap:kt,displacementMap:Cn,emissiveMap:wt,normalMapObjectSpace:kt&&x.normalMapType===jy,normalMapTangentSpace:kt&&x.normalMapType===El,packedNormalMap:kt&&x.normalMapType===El&&NC(x.normalMap.format),metalnessMap:yn,roughnessMap:en,anisotropy:hn,anisotropyMap:Ye,clearcoat:F,clearcoatMap:R,clearcoatNormalMap:S,clearcoatRoughnessMap:$,diffuseRoughness:Ie,diffuseRoughnessMap:he,dispersion:Je,retroreflection:lt,iridescence:Ee,iridescenceMap:re,iridescenceThicknessMap:ye,sheen:zt,sheenColorMap:ve,sheenRoughnessMap:ee,specularMap:ne,specularColorMap:pe,specularIntensityMap:O,transmission:He,transmissionMap:se,thicknessMap:te,gradientMap:Te,opaque:x.transparent===!1&&x.blending===qo&&x.alphaToCoverage===!1,alphaMap:_e,alphaTest:Se,alphaHash:$e,combine:x.combine,mapUv:We&&f(x.map.channel),aoMapUv:jt&&f(x.aoMap.channel),lightMapUv:Ht&&f(x.lightMap.channel),bumpMapUv:cn&&f(x.bumpMap.channel),normalMapUv:kt&&f(x.normalMap.channel),displacementMapUv:Cn&&f(x.displacementMap.channel),emissiveMapUv:wt&&f(x.emissiveMap.channel),metalnessMapUv:yn&&f(x.metalnessMap.channel),roughnessMapUv:en&&f(x.roughnessMap.channel),anisotropyMapUv:Ye&&f(x.anisotropyMap.channel),clearcoatMapUv:R&&f(x.clearcoatMap.channel),clearcoatNormalMapUv:S&&f(x.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:$&&f(x.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:he&&f(x.diffuseRoughnessMap.channel),iridescenceMapUv:re&&f(x.iridescenceMap.channel),iridescenceThicknessMapUv:ye&&f(x.iridescenceThicknessMap.channel),sheenColorMapUv:ve&&f(x.sheenColorMap.channel),sheenRoughnessMapUv:ee&&f(x.sheenRoughnessMap.channel),specularMapUv:ne&&f(x.specularMap.channel),specularColorMapUv:pe&&f(x.specularColorMap.channel),specularIntensityMapUv:O&&f(x.specularIntensityMap.channel),transmissionMapUv:se&&f(x.transmissionMap.channel),thicknessMapUv:te&&f(x.thicknessMap.channel),alphaMapUv:_e&&f(x.alphaMap.channel),vertexTangents:!!U.attributes.tangent&&(kt||hn),vertexNormals:!!U.attributes.normal,vertexColors:x.vertexColors,vertexAlphas:x.vertexColors===!0&&!!U.attributes.color&&U.attributes.color.itemSize===4,pointsUvs:D.isPoints===!0&&!!U.attributes.uv&&(We||_e),fog:!!W,useFog:x.fog===!0,fogExp2:!!W&&W.isFogExp2,flatShading:x.wireframe===!1&&(x.flatShading===!0||U.attributes.normal===void 0&&kt===!1&&(x.isMeshLambertMaterial||x.isMeshPhongMaterial||x.isMeshStandardMaterial||x.isMeshPhysicalMaterial)),sizeAttenuation:x.sizeAttenuation===!0,logarithmicDepthBuffer:u,reversedDepthBuffer:we,skinning:D.isSkinnedMesh===!0,hasPositionAttribute:U.attributes.position!==void 0,morphTargets:U.morphAttributes.position!==void 0,morphNormals:U.morphAttributes.normal!==void 0,morphColors:U.morphAttributes.color!==void 0,morphTargetsCount:ie,morphTextureStride:de,numSunLights:M.sun.length,numDirLights:M.directional.length,numPointLights:M.point.length,numSpotLights:M.spot.length,numSpotLightMaps:M.spotLightMap.length,numRectAreaLights:M.rectArea.length,numHemiLights:M.hemi.length,numSunLightShadows:M.sunShadowMap.length,numDirLightShadows:M.directionalShadowMap.length,numPointLightShadows:M.pointShadowMap.length,numSpotLightShadows:M.spotShadowMap.length,numSpotLightShadowsWithMaps:M.numSpotLightShadowsWithMaps,numLightProbes:M.numLightProbes,numLightProbeGrids:V.filter(Pe=>Pe.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:x.dithering,shadowMapEnabled:i.shadowMap.enabled&&k.length>0,shadowMapType:i.shadowMap.type,toneMapping:le,decodeVideoTexture:We&&x.map.isVideoTexture===!0&&bt.getTransfer(x.map.colorSpace)===Dt,decodeVideoTextureEmissive:wt&&x.emissiveMap.isVideoTexture===!0&&bt.getTransfer(x.emissiveMap.colorSpace)===Dt,premultipliedAlpha:x.premultipliedAlpha,doubleSided:x.side===Ai,flipSided:x.side===Kn,useDepthPacking:x.depthPacking>=0,depthPacking:x.depthPacking||0,index0AttributeName:x.index0AttributeName,extensionClipCullDistance:et&&x.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(et&&x.extensions.multiDraw===!0||at)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:x.customProgramCacheKey()};return tt.vertexUv1s=l.has(1),tt.vertexUv2s=l.has(2),tt.vertexUv3s=l.has(3),l.clear(),tt}function _(x){let M=[];if(x.shaderID?M.push(x.shaderID):(M.push(x.customVertexShaderID),M.push(x.customFragmentShaderID)),x.defines!==void 0)for(let k in x.defines)M.push(k),M.push(x.defines[k]);return x.isRawShaderMaterial===!1&&(m(M,x),g(M,x),M.push(i.outputColorSpace)),M.push(x.customProgramCacheKey),M.join()}function m(x,M){x.push(M.precision),x.push(M.outputColorSpace),x.push(M.envMapMode),x.push(M.envMapPMREM),x.push(M.envMapMaxLod),x.push(M.envMapSize),x.push(M.mapUv),x.push(M.alphaMapUv),x.push(M.lightMapUv),x.push(M.aoMapUv),x.push(M.bumpMapUv),x.push(M.normalMapUv),x.push(M.displacementMapUv),x.push(M.emissiveMapUv),x.push(M.metalnessMapUv),x.push(M.roughnessMapUv),x.push(M.anisotropyMapUv),x.push(M.clearcoatMapUv),x.push(M.clearcoatNormalMapUv),x.push(M.clearcoatRoughnessMapUv),x.push(M.diffuseRoughnessMapUv),x.push(M.iridescenceMapUv),x.push(M.iridescenceThicknessMapUv),x.push(M.sheenColorMapUv),x.push(M.sheenRoughnessMapUv),x.push(M.specularMapUv),x.push(M.specularColorMapUv),x.push(M.specularIntensityMapUv),x.push(M.transmissionMapUv),x.push(M.thicknessMapUv),x.push(M.combine),x.push(M.fogExp2),x.push(M.sizeAttenuation),x.push(M.morphTargetsCount),x.push(M.numSunLights),x.push(M.numDirLights),x.push(M.numPointLights),x.push(M.numSpotLights),x.push(M.numSpotLightMaps),x.push(M.numHemiLights),x.push(M.numRectAreaLights),x.push(M.numSunLightShadows),x.push(M.numDirLightShadows),x.push(M.numPointLightShadows),x.push(M.numSpotLightShadows),x.push(M.numSpotLightShadowsWithMaps),x.push(M.numLightProbes),x.push(M.numLightProbeGrids),x.push(M.shadowMapType),x.push(M.toneMapping),x.push(M.numClippingPlanes),x.push(M.numClipIntersection),x.push(M.depthPacking)}function g(x,M){o.disableAll(),M.instancing&&o.enable(0),M.instancingColor&&o.enable(1),M.instancingMorph&&o.enable(2),M.matcap&&o.enable(3),M.envMap&&o.enable(4),M.normalMapObjectSpace&&o.enable(5),M.normalMapTangentSpace&&o.enable(6),M.clearcoat&&o.enable(7),M.iridescence&&o.enable(8),M.alphaTest&&o.enable(9),M.vertexColors&&o.enable(10),M.vertexAlphas&&o.enable(11),M.vertexUv1s&&o.enable(12),M.vertexUv2s&&o.enable(13),M.vertexUv3s&&o.enable(14),M.vertexTangents&&o.enable(15),M.anisotropy&&o.enable(16),M.alphaHash&&o.enable(17),M.batching&&o.enable(18),M.dispersion&&o.enable(19),M.retroreflection&&o.enable(24),M.diffuseRoughness&&o.enable(25),M.batchingColor&&o.enable(20),M.gradientMap&&o.enable(21),M.packedNormalMap&&o.enable(22),M.vertexNormals&&o.enable(23),x.push(o.mask),o.disableAll(),M.fog&&o.enable(0),M.useFog&&o.enable(1),M.flatShading&&o.enable(2),M.logarithmicDepthBuffer&&o.enable(3),M.reversedDepthBuffer&&o.enable(4),M.skinning&&o.enable(5),M.morphTargets&&o.enable(6),M.morphNormals&&o.enable(7),M.morphColors&&o.enable(8),M.premultipliedAlpha&&o.enable(9),M.shadowMapEnabled&&o.enable(10),M.doubleSided&&o.enable(11),M.flipSided&&o.enable(12),M.useDepthPacking&&o.enable(13),M.dithering&&o.enable(14),M.transmission&&o.enable(15),M.sheen&&o.enable(16),M.opaque&&o.enable(17),M.pointsUvs&&o.enable(18),M.decodeVideoTexture&&o.enable(19),M.decodeVideoTextureEmissive&&o.enable(20),M.alphaToCoverage&&o.enable(21),M.numLightProbeGrids>0&&o.enable(22),M.hasPositionAttribute&&o.enable(23),x.push(o.mask)}function y(x){let M=d[x.type],k;if(M){let N=us[M];k=cx.clone(N.uniforms)}else k=x.uniforms;return k}function T(x,M){let k=h.get(M);return k!==void 0?++k.usedTimes:(k=new LC(i,M,x,s),c.push(k),h.set(M,k)),k}function b(x){if(--x.usedTimes===0){let M=c.indexOf(x);c[M]=c[c.length-1],c.pop(),h.delete(x.cacheKey),x.destroy()}}function C(x){a.remove(x)}function A(){a.dispose()}return{getParameters:p,getProgramCacheKey:_,getUniforms:y,acquireProgram:T,releaseProgram:b,releaseShaderCache:C,programs:c,dispose:A}}function OC(){let i=new WeakMap;function e(o){return i.has(o)}function t(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:e,get:t,remove:n,update:s,dispose:r}}function FC(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==e.material.id?i.material.id-e.material.id:i.materialVariant!==e.materialVariant?i.materialVariant-e.materialVariant:i.z!==e.z?i.z-e.z:i.id-e.id}function Rx(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}function Px(){let i=[],e=0,t=[],n=[],s=[];function r(){e=0,t.length=0,n.length=0,s.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,p,_,m,g){let y=i[e];return y===void 0?(y={id:d.id,object:d,geometry:f,material:p,materialVariant:o(d),groupOrder:_,renderOrder:d.renderOrder,z:m,group:g},i[e]=y):(y.id=d.id,y.object=d,y.geometry=f,y.material=p,y.materialVariant=o(d),y.groupOrder=_,y.renderOrder=d.renderOrder,y.z=m,y.group=g),e++,y}function l(d,f,p,_,m,g,y){y.reversedDepth===!0&&(m=-m);let T=a(d,f,p,_,m,g);p.transmission>0?n.push(T):p.transparent===!0?s.push(T):t.push(T)}function c(d,f,p,_,m,g){let y=a(d,f,p,_,m,g);p.transmission>0?n.unshift(y):p.transparent===!0?s.unshift(y):t.unshift(y)}function h(d,f){t.length>1&&t.sort(d||FC),n.length>1&&n.sort(f||Rx),s.length>1&&s.sort(f||Rx)}function u(){for(let d=e,f=i.length;d<f;d++){let p=i[d];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:t,transmissive:n,transparent:s,init:r,push:l,unshift:c,finish:u,sort:h}}function kC(){let i=new WeakMap;function e(n,s){let r=i.get(n),o;return r===void 0?(o=new Px,i.set(n,[o])):s>=r.length?(o=new Px,r.push(o)):o=r[s],o}function t(){i=new WeakMap}return{get:e,dispose:t}}function BC(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new I,color:new it};break;case"SpotLight":t={position:new I,direction:new I,color:new it,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new I,color:new it,distance:0,decay:0};break;case"HemisphereLight":t={direction:new I,skyColor:new it,groundColor:new it};break;case"RectAreaLight":t={color:new it,position:new I,halfWidth:new I,halfHeight:new I};break}return i[e.id]=t,t}}}function zC(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Me};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Me};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Me,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.id]=t,t}}}var VC=0;function GC(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}function HC(i){let e=new BC,t=zC(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new I);let s=new I,r=new St,o=new St;function a(c){let h=0,u=0,d=0;for(let V=0;V<9;V++)n.probe[V].set(0,0,0);let f=0,p=0,_=0,m=0,g=0,y=0,T=0,b=0,C=0,A=0,x=0,M=0,k=0,N=0;c.sort(GC);for(let V=0,W=c.length;V<W;V++){let U=c[V],G=U.color,Z=U.intensity,z=U.distance,ce=null;if(U.shadow&&U.shadow.map&&(U.shadow.map.texture.format===hr?ce=U.shadow.map.texture:ce=U.shadow.map.depthTexture||U.shadow.map.texture),U.isAmbientLight)h+=G.r*Z,u+=G.g*Z,d+=G.b*Z;else if(U.isLightProbe){for(let j=0;j<9;j++)n.probe[j].addScaledVector(U.sh.coefficients[j],Z);N++}else if(U.isSunLight){let j=e.get(U);if(j.color.copy(U.color).multiplyScalar(U.intensity),U.castShadow){let K=U.shadow,ie=t.get(U);ie.shadowIntensity=K.intensity,ie.shadowBias=K.bias,ie.shadowNormalBias=K.normalBias,ie.shadowRadius=K.radius,ie.shadowMapSize.copy(K.mapSize).multiply(K.getFrameExtents()),n.sunShadow[p]=ie,n.sunShadowMap[p]=ce;let de=K.getViewportCount();for(let ue=0;ue<de;ue++)n.sunShadowMatrix[_+ue]=K.getMatrix(ue),n.sunShadowCascade[_+ue]=K._cascadeData[ue];_+=de,p++}n.sun[f]=j,f++}else if(U.isDirectionalLight){let j=e.get(U);if(j.color.copy(U.color).multiplyScalar(U.intensity),U.castShadow){let K=U.shadow,ie=t.get(U);ie.shadowIntensity=K.intensity,ie.shadowBias=K.bias,ie.shadowNormalBias=K.normalBias,ie.shadowRadius=K.radius,ie.shadowMapSize=K.mapSize,n.directionalShadow[m]=ie,n.directionalShadowMap[m]=ce,n.directionalShadowMatrix[m]=U.shadow.matrix,C++}n.directional[m]=j,m++}else if(U.isSpotLight){let j=e.get(U);j.position.setFromMatrixPosition(U.matrixWorld),j.color.copy(G).multiplyScalar(Z),j.distance=z,j.coneCos=Math.cos(U.angle),j.penumbraCos=Math.cos(U.angle*(1-U.penumbra)),j.decay=U.decay,n.spot[y]=j;let K=U.shadow;if(U.map&&(n.spotLightMap[M]=U.map,M++,K.updateMatrices(U),U.castShadow&&k++),n.spotLightMatrix[y]=K.matrix,U.castShadow){let ie=t.get(U);ie.shadowIntensity=K.intensity,ie.shadowBias=K.bias,ie.shadowNormalBias=K.normalBias,ie.shadowRadius=K.radius,ie.shadowMapSize=K.mapSize,n.spotShadow[y]=ie,n.spotShadowMap[y]=ce,x++}y++}else if(U.isRectAreaLight){let j=e.get(U);j.color.copy(G).multiplyScalar(Z),j.halfWidth.set(U.width*.5,0,0),j.halfHeight.set(0,U.height*.5,0),n.rectArea[T]=j,T++}else if(U.isPointLight){let j=e.get(U);if(j.color.copy(U.color).multiplyScalar(U.intensity),j.distance=U.distance,j.decay=U.decay,U.castShadow){let K=U.shadow,ie=t.get(U);ie.shadowIntensity=K.intensity,ie.shadowBias=K.bias,ie.shadowNormalBias=K.normalBias,ie.shadowRadius=K.radius,ie.shadowMapSize=K.mapSize,ie.shadowCameraNear=K.camera.near,ie.shadowCameraFar=K.camera.far,n.pointShadow[g]=ie,n.pointShadowMap[g]=ce,n.pointShadowMatrix[g]=U.shadow.matrix,A++}n.point[g]=j,g++}else if(U.isHemisphereLight){let j=e.get(U);j.skyColor.copy(U.color).multiplyScalar(Z),j.groundColor.copy(U.groundColor).multiplyScalar(Z),n.hemi[b]=j,b++}}T>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Ne.LTC_FLOAT_1,n.rectAreaLTC2=Ne.LTC_FLOAT_2):(n.rectAreaLTC1=Ne.LTC_HALF_1,n.rectAreaLTC2=Ne.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=u,n.ambient[2]=d;let D=n.hash;(D.sunLength!==f||D.directionalLength!==m||D.pointLength!==g||D.spotLength!==y||D.rectAreaLength!==T||D.hemiLength!==b||D.numSunShadows!==p||D.numDirectionalShadows!==C||D.numPointShadows!==A||D.numSpotShadows!==x||D.numSpotMaps!==M||D.numLightProbes!==N)&&(n.sun.length=f,n.directional.length=m,n.spot.length=y,n.rectArea.length=T,n.point.length=g,n.hemi.length=b,n.sunShadow.length=p,n.sunShadowMap.length=p,n.sunShadowMatrix.length=_,n.sunShadowCascade.length=_,n.directionalShadow.length=C,n.directionalShadowMap.length=C,n.directionalShadowMatrix.length=C,n.pointShadow.length=A,n.pointShadowMap.length=A,n.pointShadowMatrix.length=A,n.spotShadow.length=x,n.spotShadowMap.length=x,n.spotLightMatrix.length=x+M-k,n.spotLightMap.length=M,n.numSpotLightShadowsWithMaps=k,n.numLightProbes=N,D.sunLength=f,D.directionalLength=m,D.pointLength=g,D.spotLength=y,D.rectAreaLength=T,D.hemiLength=b,D.numSunShadows=p,D.numDirectionalShadows=C,D.numPointShadows=A,D.numSpotShadows=x,D.numSpotMaps=M,D.numLightProbes=N,n.version=VC++)}function l(c,h){let u=0,d=0,f=0,p=0,_=0,m=0,g=h.matrixWorldInverse;for(let y=0,T=c.length;y<T;y++){let b=c[y];if(b.isSunLight){let C=n.sun[u];C.direction.setFromMatrixPosition(b.matrixWorld),C.direction.transformDirection(g),u++}else if(b.isDirectionalLight){let C=n.directional[d];C.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(g),d++}else if(b.isSpotLight){let C=n.spot[p];C.position.setFromMatrixPosition(b.matrixWorld),C.position.applyMatrix4(g),C.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(g),p++}else if(b.isRectAreaLight){let C=n.rectArea[_];C.position.setFromMatrixPosition(b.matrixWorld),C.position.applyMatrix4(g),o.identity(),r.copy(b.matrixWorld),r.premultiply(g),o.extractRotation(r),C.halfWidth.set(b.width*.5,0,0),C.halfHeight.set(0,b.height*.5,0),C.halfWidth.applyMatrix4(o),C.halfHeight.applyMatrix4(o),_++}else if(b.isPointLight){let C=n.point[f];C.position.setFromMatrixPosition(b.matrixWorld),C.position.applyMatrix4(g),f++}else if(b.isHemisphereLight){let C=n.hemi[m];C.direction.setFromMatrixPosition(b.matrixWorld),C.direction.transformDirection(g),m++}}}return{setup:a,setupView:l,state:n}}function Ix(i){let e=new HC(i),t=[],n=[],s=[];function r(u){h.camera=u,t.length=0,n.length=0,s.length=0}function o(u){u.isLightProbeGrid?s.push(u):t.push(u)}function a(u){n.push(u)}function l(){e.setup(t),s.sort((u,d)=>u.priority-d.priority||u.id-d.id)}function c(u){e.setupView(t,u)}let h={lightsArray:t,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function WC(i){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new Ix(i),e.set(s,[a])):r>=o.length?(a=new Ix(i),o.push(a)):a=o[r],a}function n(){e=new WeakMap}return{get:t,dispose:n}}var $C=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,qC=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,XC=[new I(1,0,0),new I(-1,0,0),new I(0,1,0),new I(0,-1,0),new I(0,0,1),new I(0,0,-1)],YC=[new I(0,-1,0),new I(0,-1,0),new I(0,0,1),new I(0,0,-1),new I(0,-1,0),new I(0,-1,0)],Lx=new St,Tl=new I,Vp=new I;function ZC(i,e,t){let n=new tr,s=new Me,r=new Me,o=new Kt,a=new kh,l=new Bh,c={},h=t.maxTextureSize,u={[cr]:Kn,[Kn]:cr,[Ai]:Ai},d=new ls({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Me},radius:{value:4}},vertexShader:$C,fragmentShader:qC}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let p=new Nt;p.setAttribute("position",new pi(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let _=new Mt(p,d),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=_l;let g=this.type;this.render=function(A,x,M){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||A.length===0)return;this.type===Ay&&(Ze("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=_l);let k=i.getRenderTarget(),N=i.getActiveCubeFace(),D=i.getActiveMipmapLevel(),V=i.state;V.setBlending(Ur),V.buffers.depth.getReversed()===!0?V.buffers.color.setClear(0,0,0,0):V.buffers.color.setClear(1,1,1,1),V.buffers.depth.setTest(!0),V.setScissorTest(!1);let W=g!==this.type;W&&x.traverse(function(U){U.material&&(Array.isArray(U.material)?U.material.forEach(G=>G.needsUpdate=!0):U.material.needsUpdate=!0)});for(let U=0,G=A.length;U<G;U++){let Z=A[U],z=Z.shadow;if(z===void 0){Ze("WebGLShadowMap:",Z,"has no shadow.");continue}if(z.autoUpdate===!1&&z.needsUpdate===!1)continue;s.copy(z.mapSize);let ce=z.getFrameExtents();s.multiply(ce),r.copy(z.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/ce.x),s.x=r.x*ce.x,z.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/ce.y),s.y=r.y*ce.y,z.mapSize.y=r.y));let j=i.state.buffers.depth.getReversed();if(z.camera._reversedDepth=j,z.map===null||W===!0){if(z.map!==null&&(z.map.depthTexture!==null&&(z.map.depthTexture.dispose(),z.map.depthTexture=null),z.map.dispose()),this.type===$o){if(Z.isPointLight){Ze("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}z.map=new mi(s.x,s.y,{format:hr,type:Wi,minFilter:jn,magFilter:jn,generateMipmaps:!1}),z.map.texture.name=Z.name+".shadowMap",z.map.depthTexture=new Ps(s.x,s.y,Hi),z.map.depthTexture.name=Z.name+".shadowMapDepth",z.map.depthTexture.format=As,z.map.depthTexture.compareFunction=null,z.map.depthTexture.minFilter=Nn,z.map.depthTexture.magFilter=Nn}else Z.isPointLight?(z.map=new Cl(s.x),z.map.depthTexture=new Ka(s.x,Gi)):(z.map=new mi(s.x,s.y),z.map.depthTexture=new Ps(s.x,s.y,Gi)),z.map.depthTexture.name=Z.name+".shadowMap",z.map.depthTexture.format=As,this.type===_l?(z.map.depthTexture.compareFunction=j?Tp:Ep,z.map.depthTexture.minFilter=jn,z.map.depthTexture.magFilter=jn):(z.map.depthTexture.compareFunction=null,z.map.depthTexture.minFilter=Nn,z.map.depthTexture.magFilter=Nn);z.camera.updateProjectionMatrix()}z.map.isWebGLCubeRenderTarget!==!0&&(z.map.width!==s.x||z.map.height!==s.y)&&z.map.setSize(s.x,s.y);let K=z.map.isWebGLCubeRenderTarget?6:z.getViewportCount();Z.isPointLight!==!0&&z.updateMatrices(Z,M);let ie=(z.camera.layers.mask&4294967294)!==0?z.camera.layers:M.layers;for(let de=0;de<K;de++){let ue=z.getCamera(de);if(Z.isPointLight){let Q=z.camera,ge=z.matrix,xe=Z.distance||Q.far;xe!==Q.far&&(Q.far=xe,Q.updateProjectionMatrix()),Tl.setFromMatrixPosition(Z.matrixWorld),Q.position.copy(Tl),Vp.copy(Q.position),Vp.add(XC[de]),Q.up.copy(YC[de]),Q.lookAt(Vp),Q.updateMatrixWorld(),ge.makeTranslation(-Tl.x,-Tl.y,-Tl.z),Lx.multiplyMatrices(Q.projectionMatrix,Q.matrixWorldInverse),z._frustum.setFromProjectionMatrix(Lx,Q.coordinateSystem,Q.reversedDepth)}if(z.map.isWebGLCubeRenderTarget)i.setRenderTarget(z.map,de),i.clear();else{de===0&&(i.setRenderTarget(z.map),i.clear());let Q=z.getViewport(de);o.set(r.x*Q.x,r.y*Q.y,r.x*Q.z,r.y*Q.w),V.viewport(o)}n=z.getFrustum(de),b(x,M,ue,Z,ie,this.type)}z.isPointLightShadow!==!0&&this.type===$o&&y(z,M),z.needsUpdate=!1}g=this.type,m.needsUpdate=!1,i.setRenderTarget(k,N,D)};function y(A,x){let M=e.update(_);d.defines.VSM_SAMPLES!==A.blurSamples&&(d.defines.VSM_SAMPLES=A.blurSamples,f.defines.VSM_SAMPLES=A.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),A.mapPass===null?A.mapPass=new mi(s.x,s.y,{format:hr,type:Wi}):(A.mapPass.width!==A.map.width||A.mapPass.height!==A.map.height)&&A.mapPass.setSize(A.map.width,A.map.height),d.uniforms.shadow_pass.value=A.map.depthTexture,d.uniforms.resolution.value.set(A.map.width,A.map.height),d.uniforms.radius.value=A.radius,i.setRenderTarget(A.mapPass),i.clear(),i.renderBufferDirect(x,null,M,d,_,null),f.uniforms.shadow_pass.value=A.mapPass.texture,f.uniforms.resolution.value.set(A.map.width,A.map.height),f.uniforms.radius.value=A.radius,i.setRenderTarget(A.map),i.clear(),i.renderBufferDirect(x,null,M,f,_,null)}function T(A,x,M,k){let N=null,D=M.isPointLight===!0?A.customDistanceMaterial:A.customDepthMaterial;if(D!==void 0)N=D;else if(N=M.isPointLight===!0?l:a,i.localClippingEnabled&&x.clipShadows===!0&&Array.isArray(x.clippingPlanes)&&x.clippingPlanes.length!==0||x.displacementMap&&x.displacementScale!==0||x.alphaMap&&x.alphaTest>0||x.map&&x.alphaTest>0||x.alphaToCoverage===!0){let V=N.uuid,W=x.uuid,U=c[V];U===void 0&&(U={},c[V]=U);let G=U[W];G===void 0&&(G=N.clone(),U[W]=G,x.addEventListener("dispose",C)),N=G}if(N.visible=x.visible,N.wireframe=x.wireframe,k===$o?N.side=x.shadowSide!==null?x.shadowSide:x.side:N.side=x.shadowSide!==null?x.shadowSide:u[x.side],N.alphaMap=x.alphaMap,N.alphaTest=x.alphaToCoverage===!0?.5:x.alphaTest,N.map=x.map,N.clipShadows=x.clipShadows,N.clippingPlanes=x.clippingPlanes,N.clipIntersection=x.clipIntersection,N.displacementMap=x.displacementMap,N.displacementScale=x.displacementScale,N.displacementBias=x.displacementBias,N.wireframeLinewidth=x.wireframeLinewidth,N.linewidth=x.linewidth,M.isPointLight===!0&&N.isMeshDistanceMaterial===!0){let V=i.properties.get(N);V.light=M}return N}function b(A,x,M,k,N,D){if(A.visible===!1)return;if(A.layers.test(N)&&(A.isMesh||A.isLine||A.isPoints)&&(A.castShadow||A.receiveShadow&&D===$o)&&(!A.frustumCulled||A.intersectsFrustum(n))){A.modelViewMatrix.multiplyMatrices(M.matrixWorldInverse,A.matrixWorld);let U=e.update(A),G=A.material;if(Array.isArray(G)){let Z=U.groups;for(let z=0,ce=Z.length;z<ce;z++){let j=Z[z],K=G[j.materialIndex];if(K&&K.visible){let ie=T(A,K,k,D);A.onBeforeShadow(i,A,x,M,U,ie,j),i.renderBufferDirect(M,null,U,ie,A,j),A.onAfterShadow(i,A,x,M,U,ie,j)}}}else if(G.visible){let Z=T(A,G,k,D);A.onBeforeShadow(i,A,x,M,U,Z,null),i.renderBufferDirect(M,null,U,Z,A,null),A.onAfterShadow(i,A,x,M,U,Z,null)}}let W=A.children;for(let U=0,G=W.length;U<G;U++)b(W[U],x,M,k,N,D)}function C(A){A.target.removeEventListener("dispose",C);for(let M in c){let k=c[M],N=A.target.uuid;N in k&&(k[N].dispose(),delete k[N])}}}function jC(i,e){function t(){let O=!1,se=new Kt,te=null,Te=new Kt(0,0,0,0);return{setMask:function(_e){te!==_e&&!O&&(i.colorMask(_e,_e,_e,_e),te=_e)},setLocked:function(_e){O=_e},setClear:function(_e,Se,$e,et,le){le===!0&&(_e*=et,Se*=et,$e*=et),se.set(_e,Se,$e,et),Te.equals(se)===!1&&(i.clearColor(_e,Se,$e,et),Te.copy(se))},reset:function(){O=!1,te=null,Te.set(-1,0,0,0)}}}function n(){let O=!1,se=!1,te=null,Te=null,_e=null;return{setReversed:function(Se){if(se!==Se){let $e=e.get("EXT_clip_control");Se?$e.clipControlEXT($e.LOWER_LEFT_EXT,$e.ZERO_TO_ONE_EXT):$e.clipControlEXT($e.LOWER_LEFT_EXT,$e.NEGATIVE_ONE_TO_ONE_EXT),se=Se;let et=_e;_e=null,this.setClear(et)}},getReversed:function(){return se},setTest:function(Se){Se?we(i.DEPTH_TEST):qe(i.DEPTH_TEST)},setMask:function(Se){te!==Se&&!O&&(i.depthMask(Se),te=Se)},setFunc:function(Se){if(se&&(Se=ox[Se]),Te!==Se){switch(Se){case uh:i.depthFunc(i.NEVER);break;case dh:i.depthFunc(i.ALWAYS);break;case fh:i.depthFunc(i.LESS);break;case Do:i.depthFunc(i.LEQUAL);break;case ph:i.depthFunc(i.EQUAL);break;case mh:i.depthFunc(i.GEQUAL);break;case gh:i.depthFunc(i.GREATER);break;case _h:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}Te=Se}},setLocked:function(Se){O=Se},setClear:function(Se){_e!==Se&&(_e=Se,se&&(Se=1-Se),i.clearDepth(Se))},reset:function(){O=!1,te=null,Te=null,_e=null,se=!1}}}function s(){let O=!1,se=null,te=null,Te=null,_e=null,Se=null,$e=null,et=null,le=null;return{setTest:function(ze){O||(ze?we(i.STENCIL_TEST):qe(i.STENCIL_TEST))},setMask:function(ze){se!==ze&&!O&&(i.stencilMask(ze),se=ze)},setFunc:function(ze,tt,Pe){(te!==ze||Te!==tt||_e!==Pe)&&(i.stencilFunc(ze,tt,Pe),te=ze,Te=tt,_e=Pe)},setOp:function(ze,tt,Pe){(Se!==ze||$e!==tt||et!==Pe)&&(i.stencilOp(ze,tt,Pe),Se=ze,$e=tt,et=Pe)},setLocked:function(ze){O=ze},setClear:function(ze){le!==ze&&(i.clearStencil(ze),le=ze)},reset:function(){O=!1,se=null,te=null,Te=null,_e=null,Se=null,$e=null,et=null,le=null}}}let r=new t,o=new n,a=new s,l={},c=new WeakMap,h={},u={},d={},f=new WeakMap,p=[],_=null,m=!1,g=null,y=null,T=null,b=null,C=null,A=null,x=null,M=new it(0,0,0),k=0,N=!1,D=null,V=null,W=null,U=null,G=null,Z=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),z=!1,ce=0,j=i.getParameter(i.VERSION);j.indexOf("WebGL")!==-1?(ce=parseFloat(/^WebGL (\d)/.exec(j)[1]),z=ce>=1):j.indexOf("OpenGL ES")!==-1&&(ce=parseFloat(/^OpenGL ES (\d)/.exec(j)[1]),z=ce>=2);let K=null,ie={},de=i.getParameter(i.SCISSOR_BOX),ue=i.getParameter(i.VIEWPORT),Q=new Kt().fromArray(de),ge=new Kt().fromArray(ue);function xe(O,se,te,Te){let _e=new Uint8Array(4),Se=i.createTexture();i.bindTexture(O,Se),i.texParameteri(O,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(O,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let $e=0;$e<te;$e++)O===i.TEXTURE_3D||O===i.TEXTURE_2D_ARRAY?i.texImage3D(se,0,i.RGBA,1,1,Te,0,i.RGBA,i.UNSIGNED_BYTE,_e):i.texImage2D(se+$e,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,_e);return Se}let Re={};Re[i.TEXTURE_2D]=xe(i.TEXTURE_2D,i.TEXTURE_2D,1),Re[i.TEXTURE_CUBE_MAP]=xe(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),Re[i.TEXTURE_2D_ARRAY]=xe(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Re[i.TEXTURE_3D]=xe(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),we(i.DEPTH_TEST),o.setFunc(Do),cn(!1),kt(sp),we(i.CULL_FACE),jt(Ur);function we(O){h[O]!==!0&&(i.enable(O),h[O]=!0)}function qe(O){h[O]!==!1&&(i.disable(O),h[O]=!1)}function at(O,se){return d[O]!==se?(i.bindFramebuffer(O,se),d[O]=se,O===i.DRAW_FRAMEBUFFER&&(d[i.FRAMEBUFFER]=se),O===i.FRAMEBUFFER&&(d[i.DRAW_FRAMEBUFFER]=se),!0):!1}function We(O,se){let te=p,Te=!1;if(O){te=f.get(se),te===void 0&&(te=[],f.set(se,te));let _e=O.textures;if(te.length!==_e.length||te[0]!==i.COLOR_ATTACHMENT0){for(let Se=0,$e=_e.length;Se<$e;Se++)te[Se]=i.COLOR_ATTACHMENT0+Se;te.length=_e.length,Te=!0}}else te[0]!==i.BACK&&(te[0]=i.BACK,Te=!0);Te&&i.drawBuffers(te)}function mt(O){return _!==O?(i.useProgram(O),_=O,!0):!1}let dt={[Or]:i.FUNC_ADD,[Ry]:i.FUNC_SUBTRACT,[Py]:i.FUNC_REVERSE_SUBTRACT};dt[Iy]=i.MIN,dt[Ly]=i.MAX;let rt={[Dy]:i.ZERO,[Ny]:i.ONE,[Uy]:i.SRC_COLOR,[lp]:i.SRC_ALPHA,[Vy]:i.SRC_ALPHA_SATURATE,[By]:i.DST_COLOR,[Fy]:i.DST_ALPHA,[Oy]:i.ONE_MINUS_SRC_COLOR,[cp]:i.ONE_MINUS_SRC_ALPHA,[zy]:i.ONE_MINUS_DST_COLOR,[ky]:i.ONE_MINUS_DST_ALPHA,[Gy]:i.CONSTANT_COLOR,[Hy]:i.ONE_MINUS_CONSTANT_COLOR,[Wy]:i.CONSTANT_ALPHA,[$y]:i.ONE_MINUS_CONSTANT_ALPHA};function jt(O,se,te,Te,_e,Se,$e,et,le,ze){if(O===Ur){m===!0&&(qe(i.BLEND),m=!1);return}if(m===!1&&(we(i.BLEND),m=!0),O!==Cy){if(O!==g||ze!==N){if((y!==Or||C!==Or)&&(i.blendEquation(i.FUNC_ADD),y=Or,C=Or),ze)switch(O){case qo:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case rp:i.blendFunc(i.ONE,i.ONE);break;case op:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case ap:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:Qe("WebGLState: Invalid blending: ",O);break}else switch(O){case qo:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case rp:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case op:Qe("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case ap:Qe("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:Qe("WebGLState: Invalid blending: ",O);break}T=null,b=null,A=null,x=null,M.set(0,0,0),k=0,g=O,N=ze}return}_e=_e||se,Se=Se||te,$e=$e||Te,(se!==y||_e!==C)&&(i.blendEquationSeparate(dt[se],dt[_e]),y=se,C=_e),(te!==T||Te!==b||Se!==A||$e!==x)&&(i.blendFuncSeparate(rt[te],rt[Te],rt[Se],rt[$e]),T=te,b=Te,A=Se,x=$e),(et.equals(M)===!1||le!==k)&&(i.blendColor(et.r,et.g,et.b,le),M.copy(et),k=le),g=O,N=!1}function Ht(O,se){O.side===Ai?qe(i.CULL_FACE):we(i.CULL_FACE);let te=O.side===Kn;se&&(te=!te),cn(te),O.blending===qo&&O.transparent===!1?jt(Ur):jt(O.blending,O.blendEquation,O.blendSrc,O.blendDst,O.blendEquationAlpha,O.blendSrcAlpha,O.blendDstAlpha,O.blendColor,O.blendAlpha,O.premultipliedAlpha),o.setFunc(O.depthFunc),o.setTest(O.depthTest),o.setMask(O.depthWrite),r.setMask(O.colorWrite);let Te=O.stencilWrite;a.setTest(Te),Te&&(a.setMask(O.stencilWriteMask),a.setFunc(O.stencilFunc,O.stencilRef,O.stencilFuncMask),a.setOp(O.stencilFail,O.stencilZFail,O.stencilZPass)),wt(O.polygonOffset,O.polygonOffsetFactor,O.polygonOffsetUnits),O.alphaToCoverage===!0?we(i.SAMPLE_ALPHA_TO_COVERAGE):qe(i.SAMPLE_ALPHA_TO_COVERAGE)}function cn(O){D!==O&&(O?i.frontFace(i.CW):i.frontFace(i.CCW),D=O)}function kt(O){O!==Ey?(we(i.CULL_FACE),O!==V&&(O===sp?i.cullFace(i.BACK):O===Ty?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):qe(i.CULL_FACE),V=O}function Cn(O){O!==W&&(z&&i.lineWidth(O),W=O)}function wt(O,se,te){O?(we(i.POLYGON_OFFSET_FILL),(U!==se||G!==te)&&(U=se,G=te,o.getReversed()&&(se=-se,te=-te),i.polygonOffset(se,te))):qe(i.POLYGON_OFFSET_FILL)}function yn(O){O?we(i.SCISSOR_TEST):qe(i.SCISSOR_TEST)}function en(O){O===void 0&&(O=i.TEXTURE0+Z-1),K!==O&&(i.activeTexture(O),K=O)}function hn(O,se,te){te===void 0&&(K===null?te=i.TEXTURE0+Z-1:te=K);let Te=ie[te];Te===void 0&&(Te={type:void 0,texture:void 0},ie[te]=Te),(Te.type!==O||Te.texture!==se)&&(K!==te&&(i.activeTexture(te),K=te),i.bindTexture(O,se||Re[O]),Te.type=O,Te.texture=se)}function F(){let O=ie[K];O!==void 0&&O.type!==void 0&&(i.bindTexture(O.type,null),O.type=void 0,O.texture=void 0)}function Ie(){try{i.compressedTexImage2D(...arguments)}catch(O){Qe("WebGLState:",O)}}function Je(){try{i.compressedTexImage3D(...arguments)}catch(O){Qe("WebGLState:",O)}}function lt(){try{i.texSubImage2D(...arguments)}catch(O){Qe("WebGLState:",O)}}function Ee(){try{i.texSubImage3D(...arguments)}catch(O){Qe("WebGLState:",O)}}function zt(){try{i.compressedTexSubImage2D(...arguments)}catch(O){Qe("WebGLState:",O)}}function He(){try{i.compressedTexSubImage3D(...arguments)}catch(O){Qe("WebGLState:",O)}}function Ye(){try{i.texStorage2D(...arguments)}catch(O){Qe("WebGLState:",O)}}function R(){try{i.texStorage3D(...arguments)}catch(O){Qe("WebGLState:",O)}}function S(){try{i.texImage2D(...arguments)}catch(O){Qe("WebGLState:",O)}}function $(){try{i.texImage3D(...arguments)}catch(O){Qe("WebGLState:",O)}}function he(O){return u[O]!==void 0?u[O]:i.getParameter(O)}function re(O,se){u[O]!==se&&(i.pixelStorei(O,se),u[O]=se)}function ye(O){Q.equals(O)===!1&&(i.scissor(O.x,O.y,O.z,O.w),Q.copy(O))}function ve(O){ge.equals(O)===!1&&(i.viewport(O.x,O.y,O.z,O.w),ge.copy(O))}function ee(O,se){let te=c.get(se);te===void 0&&(te=new WeakMap,c.set(se,te));let Te=te.get(O);Te===void 0&&(Te=i.getUniformBlockIndex(se,O.name),i.uniformBlockBinding(se,Te,Te),te.set(O,Te))}function ne(O,se,te){let _e=c.get(se).get(O);l[_e]!==te&&(i.bindBufferBase(i.UNIFORM_BUFFER,_e,te),l[_e]=te)}function pe(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),h={},u={},K=null,ie={},d={},l={},f=new WeakMap,p=[],_=null,m=!1,g=null,y=null,T=null,b=null,C=null,A=null,x=null,M=new it(0,0,0),k=0,N=!1,D=null,V=null,W=null,U=null,G=null,Q.set(0,0,i.canvas.width,i.canvas.height),ge.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:we,disable:qe,bindFramebuffer:at,drawBuffers:We,useProgram:mt,setBlending:jt,setMaterial:Ht,setFlipSided:cn,setCullFace:kt,setLineWidth:Cn,setPolygonOffset:wt,setScissorTest:yn,activeTexture:en,bindTexture:hn,unbindTexture:F,compressedTexImage2D:Ie,compressedTexImage3D:Je,texImage2D:S,texImage3D:$,pixelStorei:re,getParameter:he,updateUBOMapping:ee,uniformBlockBinding:ne,texStorage2D:Ye,texStorage3D:R,texSubImage2D:lt,texSubImage3D:Ee,compressedTexSubImage2D:zt,compressedTexSubImage3D:He,scissor:ye,viewport:ve,reset:pe}}function JC(i,e,t,n,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Me,h=new WeakMap,u=new Set,d,f=new WeakMap,p=new Set,_=new FinalizationRegistry(R=>p.delete(R)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(R,S){return m?new OffscreenCanvas(R,S):Ha("canvas")}function y(R,S,$){let he=1,re=Ye(R);if((re.width>$||re.height>$)&&(he=$/Math.max(re.width,re.height)),he<1)if(typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&R instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&R instanceof ImageBitmap||typeof VideoFrame<"u"&&R instanceof VideoFrame){let ye=Math.floor(he*re.width),ve=Math.floor(he*re.height);d===void 0&&(d=g(ye,ve));let ee=S?g(ye,ve):d;return ee.width=ye,ee.height=ve,ee.getContext("2d").drawImage(R,0,0,ye,ve),Ze("WebGLRenderer: Texture has been resized from ("+re.width+"x"+re.height+") to ("+ye+"x"+ve+")."),ee}else return"data"in R&&Ze("WebGLRenderer: Image in DataTexture is too big ("+re.width+"x"+re.height+")."),R;return R}function T(R){return R.generateMipmaps}function b(R){i.generateMipmap(R)}function C(R){return R.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:R.isWebGL3DRenderTarget?i.TEXTURE_3D:R.isWebGLArrayRenderTarget||R.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function A(R,S,$,he,re,ye=!1){if(R!==null){if(i[R]!==void 0)return i[R];Ze("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+R+"'")}let ve;he&&(ve=e.get("EXT_texture_norm16"),ve||Ze("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let ee=S;if(S===i.RED&&($===i.FLOAT&&(ee=i.R32F),$===i.HALF_FLOAT&&(ee=i.R16F),$===i.UNSIGNED_BYTE&&(ee=i.R8),$===i.UNSIGNED_SHORT&&ve&&(ee=ve.R16_EXT),$===i.SHORT&&ve&&(ee=ve.R16_SNORM_EXT)),S===i.RED_INTEGER&&($===i.UNSIGNED_BYTE&&(ee=i.R8UI),$===i.UNSIGNED_SHORT&&(ee=i.R16UI),$===i.UNSIGNED_INT&&(ee=i.R32UI),$===i.BYTE&&(ee=i.R8I),$===i.SHORT&&(ee=i.R16I),$===i.INT&&(ee=i.R32I)),S===i.RG&&($===i.FLOAT&&(ee=i.RG32F),$===i.HALF_FLOAT&&(ee=i.RG16F),$===i.UNSIGNED_BYTE&&(ee=i.RG8),$===i.UNSIGNED_SHORT&&ve&&(ee=ve.RG16_EXT),$===i.SHORT&&ve&&(ee=ve.RG16_SNORM_EXT)),S===i.RG_INTEGER&&($===i.UNSIGNED_BYTE&&(ee=i.RG8UI),$===i.UNSIGNED_SHORT&&(ee=i.RG16UI),$===i.UNSIGNED_INT&&(ee=i.RG32UI),$===i.BYTE&&(ee=i.RG8I),$===i.SHORT&&(ee=i.RG16I),$===i.INT&&(ee=i.RG32I)),S===i.RGB_INTEGER&&($===i.UNSIGNED_BYTE&&(ee=i.RGB8UI),$===i.UNSIGNED_SHORT&&(ee=i.RGB16UI),$===i.UNSIGNED_INT&&(ee=i.RGB32UI),$===i.BYTE&&(ee=i.RGB8I),$===i.SHORT&&(ee=i.RGB16I),$===i.INT&&(ee=i.RGB32I)),S===i.RGBA_INTEGER&&($===i.UNSIGNED_BYTE&&(ee=i.RGBA8UI),$===i.UNSIGNED_SHORT&&(ee=i.RGBA16UI),$===i.UNSIGNED_INT&&(ee=i.RGBA32UI),$===i.BYTE&&(ee=i.RGBA8I),$===i.SHORT&&(ee=i.RGBA16I),$===i.INT&&(ee=i.RGBA32I)),S===i.RGB&&($===i.UNSIGNED_SHORT&&ve&&(ee=ve.RGB16_EXT),$===i.SHORT&&ve&&(ee=ve.RGB16_SNORM_EXT),$===i.UNSIGNED_INT_5_9_9_9_REV&&(ee=i.RGB9_E5),$===i.UNSIGNED_INT_10F_11F_11F_REV&&(ee=i.R11F_G11F_B10F)),S===i.RGBA){let ne=ye?Ga:bt.getTransfer(re);$===i.FLOAT&&(ee=i.RGBA32F),$===i.HALF_FLOAT&&(ee=i.RGBA16F),$===i.UNSIGNED_BYTE&&(ee=ne===Dt?i.SRGB8_ALPHA8:i.RGBA8),$===i.UNSIGNED_SHORT&&ve&&(ee=ve.RGBA16_EXT),$===i.SHORT&&ve&&(ee=ve.RGBA16_SNORM_EXT),$===i.UNSIGNED_SHORT_4_4_4_4&&(ee=i.RGBA4),$===i.UNSIGNED_SHORT_5_5_5_1&&(ee=i.RGB5_A1)}return(ee===i.R16F||ee===i.R32F||ee===i.RG16F||ee===i.RG32F||ee===i.RGBA16F||ee===i.RGBA32F)&&e.get("EXT_color_buffer_float"),ee}function x(R,S){let $;return R?S===null||S===Gi||S===kr?$=i.DEPTH24_STENCIL8:S===Hi?$=i.DEPTH32F_STENCIL8:S===Yo&&($=i.DEPTH24_STENCIL8,Ze("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):S===null||S===Gi||S===kr?$=i.DEPTH_COMPONENT24:S===Hi?$=i.DEPTH_COMPONENT32F:S===Yo&&($=i.DEPTH_COMPONENT16),$}function M(R,S){return T(R)===!0||R.isFramebufferTexture&&R.minFilter!==Nn&&R.minFilter!==jn?Math.log2(Math.max(S.width,S.height))+1:R.mipmaps.length>0?R.mipmaps.length:R.isCompressedTexture&&Array.isArray(R.image)?S.mipmaps.length:1}function k(R){let S=new WeakRef(R);n.get(R).__ref=S,p.add(S),_.register(R,S,S)}function N(R){let S=n.get(R).__ref;S!==void 0&&(p.delete(S),_.unregister(S))}function D(R){W(R.target)}function V(R){U(R.target)}function W(R){R.removeEventListener("dispose",D),N(R),Z(R),R.isVideoTexture&&h.delete(R),R.isHTMLTexture&&u.delete(R)}function U(R){R.removeEventListener("dispose",V),N(R),ce(R)}function G(){for(let R of p){let S=R.deref();S!==void 0&&(S.isRenderTarget===!0?U(S):W(S))}p.clear(),u.clear()}function Z(R){let S=n.get(R);if(S.__webglInit===void 0)return;let $=R.source,he=f.get($);if(he){let re=he[S.__cacheKey];re.usedTimes--,re.usedTimes===0&&z(R),Object.keys(he).length===0&&f.delete($)}n.remove(R)}function z(R){let S=n.get(R);i.deleteTexture(S.__webglTexture);let $=R.source,he=f.get($);delete he[S.__cacheKey],o.memory.textures--}function ce(R){let S=n.get(R);S.__depthDisposeCallback&&S.__depthDisposeCallback();let $=R.depthTexture;if($&&$.renderTarget===R&&W($),R.isWebGLCubeRenderTarget)for(let re=0;re<6;re++){if(Array.isArray(S.__webglFramebuffer[re]))for(let ye=0;ye<S.__webglFramebuffer[re].length;ye++)i.deleteFramebuffer(S.__webglFramebuffer[re][ye]);else i.deleteFramebuffer(S.__webglFramebuffer[re]);S.__webglDepthbuffer&&i.deleteRenderbuffer(S.__webglDepthbuffer[re])}else{if(Array.isArray(S.__webglFramebuffer))for(let re=0;re<S.__webglFramebuffer.length;re++)i.deleteFramebuffer(S.__webglFramebuffer[re]);else i.deleteFramebuffer(S.__webglFramebuffer);if(S.__webglDepthbuffer&&i.deleteRenderbuffer(S.__webglDepthbuffer),S.__webglMultisampledFramebuffer&&i.deleteFramebuffer(S.__webglMultisampledFramebuffer),S.__webglColorRenderbuffer)for(let re=0;re<S.__webglColorRenderbuffer.length;re++)S.__webglColorRenderbuffer[re]&&i.deleteRenderbuffer(S.__webglColorRenderbuffer[re]);S.__webglDepthRenderbuffer&&i.deleteRenderbuffer(S.__webglDepthRenderbuffer)}let he=R.textures;for(let re=0,ye=he.length;re<ye;re++){let ve=n.get(he[re]);ve.__webglTexture&&(i.deleteTexture(ve.__webglTexture),o.memory.textures--),n.remove(he[re])}n.remove(R)}let j=0;function K(){j=0}function ie(){return j}function de(R){j=R}function ue(){let R=j;return R>=s.maxTextures&&Ze("WebGLTextures: Trying to use "+(R+1)+" texture units while this GPU supports only "+s.maxTextures),j+=1,R}function Q(R){let S=[];return S.push(R.wrapS),S.push(R.wrapT),S.push(R.wrapR||0),S.push(R.magFilter),S.push(R.minFilter),S.push(R.anisotropy),S.push(R.internalFormat),S.push(R.format),S.push(R.type),S.push(R.generateMipmaps),S.push(R.mipmapsAutoUpdate),S.push(R.premultiplyAlpha),S.push(R.flipY),S.push(R.unpackAlignment),S.push(R.colorSpace),S.join()}function ge(R,S){let $=n.get(R);if(R.isVideoTexture&&zt(R),R.isRenderTargetTexture===!1&&R.isExternalTexture!==!0&&R.version>0&&$.__version!==R.version){let he=R.image;if(he===null)Ze("WebGLRenderer: Texture marked for update but no image data found.");else if(he.complete===!1)Ze("WebGLRenderer: Texture marked for update but image is incomplete");else{Ht($,R,S);return}}else R.isExternalTexture&&($.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(i.TEXTURE_2D,$.__webglTexture,i.TEXTURE0+S)}function xe(R,S){let $=n.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&$.__version!==R.version){Ht($,R,S);return}else R.isExternalTexture&&($.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(i.TEXTURE_2D_ARRAY,$.__webglTexture,i.TEXTURE0+S)}function Re(R,S){let $=n.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&$.__version!==R.version){Ht($,R,S);return}t.bindTexture(i.TEXTURE_3D,$.__webglTexture,i.TEXTURE0+S)}function we(R,S){let $=n.get(R);if(R.version>0&&$.__version!==R.version){cn($,R,S);return}t.bindTexture(i.TEXTURE_CUBE_MAP,$.__webglTexture,i.TEXTURE0+S)}let qe={[yh]:i.REPEAT,[os]:i.CLAMP_TO_EDGE,[xh]:i.MIRRORED_REPEAT},at={[Nn]:i.NEAREST,[Yy]:i.NEAREST_MIPMAP_NEAREST,[yl]:i.NEAREST_MIPMAP_LINEAR,[jn]:i.LINEAR,[tu]:i.LINEAR_MIPMAP_NEAREST,[Ls]:i.LINEAR_MIPMAP_LINEAR},We={[Ky]:i.NEVER,[Ap]:i.ALWAYS,[Qy]:i.LESS,[Ep]:i.LEQUAL,[ex]:i.EQUAL,[Tp]:i.GEQUAL,[tx]:i.GREATER,[nx]:i.NOTEQUAL};function mt(R,S){if(S.type===Hi&&e.has("OES_texture_float_linear")===!1&&(S.magFilter===jn||S.magFilter===tu||S.magFilter===yl||S.magFilter===Ls||S.minFilter===jn||S.minFilter===tu||S.minFilter===yl||S.minFilter===Ls)&&Ze("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(R,i.TEXTURE_WRAP_S,qe[S.wrapS]),i.texParameteri(R,i.TEXTURE_WRAP_T,qe[S.wrapT]),(R===i.TEXTURE_3D||R===i.TEXTURE_2D_ARRAY)&&i.texParameteri(R,i.TEXTURE_WRAP_R,qe[S.wrapR]),i.texParameteri(R,i.TEXTURE_MAG_FILTER,at[S.magFilter]),i.texParameteri(R,i.TEXTURE_MIN_FILTER,at[S.minFilter]),S.compareFunction&&(i.texParameteri(R,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(R,i.TEXTURE_COMPARE_FUNC,We[S.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(S.magFilter===Nn||S.minFilter!==yl&&S.minFilter!==Ls||S.type===Hi&&e.has("OES_texture_float_linear")===!1)return;if(S.anisotropy>1||n.get(S).__currentAnisotropy){let $=e.get("EXT_texture_filter_anisotropic");i.texParameterf(R,$.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(S.anisotropy,s.getMaxAnisotropy())),n.get(S).__currentAnisotropy=S.anisotropy}}}function dt(R,S){let $=!1;R.__webglInit===void 0&&(R.__webglInit=!0,S.addEventListener("dispose",D),k(S));let he=S.source,re=f.get(he);re===void 0&&(re={},f.set(he,re));let ye=Q(S);if(ye!==R.__cacheKey){re[ye]===void 0&&(re[ye]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,$=!0),re[ye].usedTimes++;let ve=re[R.__cacheKey];ve!==void 0&&(re[R.__cacheKey].usedTimes--,ve.usedTimes===0&&z(S)),R.__cacheKey=ye,R.__webglTexture=re[ye].texture}return $}function rt(R,S,$){return Math.floor(Math.floor(R/$)/S)}function jt(R,S,$,he){let ye=R.updateRanges;if(ye.length===0)t.texSubImage2D(i.TEXTURE_2D,0,0,0,S.width,S.height,$,he,S.data);else{ye.sort((O,se)=>O.start-se.start);let ve=0;for(let O=1;O<ye.length;O++){let se=ye[ve],te=ye[O],Te=se.start+se.count,_e=rt(te.start,S.width,4),Se=rt(se.start,S.width,4);te.start<=Te+1&&_e===Se&&rt(te.start+te.count-1,S.width,4)===_e?se.count=Math.max(se.count,te.start+te.count-se.start):(++ve,ye[ve]=te)}ye.length=ve+1;let ee=t.getParameter(i.UNPACK_ROW_LENGTH),ne=t.getParameter(i.UNPACK_SKIP_PIXELS),pe=t.getParameter(i.UNPACK_SKIP_ROWS);t.pixelStorei(i.UNPACK_ROW_LENGTH,S.width);for(let O=0,se=ye.length;O<se;O++){let te=ye[O],Te=Math.floor(te.start/4),_e=Math.ceil(te.count/4),Se=Te%S.width,$e=Math.floor(Te/S.width),et=_e,le=1;t.pixelStorei(i.UNPACK_SKIP_PIXELS,Se),t.pixelStorei(i.UNPACK_SKIP_ROWS,$e),t.texSubImage2D(i.TEXTURE_2D,0,Se,$e,et,le,$,he,S.data)}R.clearUpdateRanges(),t.pixelStorei(i.UNPACK_ROW_LENGTH,ee),t.pixelStorei(i.UNPACK_SKIP_PIXELS,ne),t.pixelStorei(i.UNPACK_SKIP_ROWS,pe)}}function Ht(R,S,$){let he=i.TEXTURE_2D;(S.isDataArrayTexture||S.isCompressedArrayTexture)&&(he=i.TEXTURE_2D_ARRAY),S.isData3DTexture&&(he=i.TEXTURE_3D);let re=dt(R,S),ye=S.source;t.bindTexture(he,R.__webglTexture,i.TEXTURE0+$);let ve=n.get(ye);if(ye.version!==ve.__version||re===!0){if(t.activeTexture(i.TEXTURE0+$),(typeof ImageBitmap<"u"&&S.image instanceof ImageBitmap)===!1){let le=bt.getPrimaries(bt.workingColorSpace),ze=S.colorSpace===Ns?null:bt.getPrimaries(S.colorSpace),tt=S.colorSpace===Ns||le===ze?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,S.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,tt)}t.pixelStorei(i.UNPACK_ALIGNMENT,S.unpackAlignment);let ne=y(S.image,!1,s.maxTextureSize);ne=He(S,ne);let pe=r.convert(S.format,S.colorSpace),O=r.convert(S.type),se=A(S.internalFormat,pe,O,S.normalized,S.colorSpace,S.isVideoTexture);mt(he,S);let te,Te=S.mipmaps,_e=S.isVideoTexture!==!0,Se=ve.__version===void 0||re===!0,$e=ye.dataReady,et=M(S,ne);if(S.isDepthTexture)se=x(S.format===Ds,S.type),Se&&(_e?t.texStorage2D(i.TEXTURE_2D,1,se,ne.width,ne.height):t.texImage2D(i.TEXTURE_2D,0,se,ne.width,ne.height,0,pe,O,null));else if(S.isDataTexture)if(Te.length>0){_e&&Se&&t.texStorage2D(i.TEXTURE_2D,et,se,Te[0].width,Te[0].height);for(let le=0,ze=Te.length;le<ze;le++)te=Te[le],_e?$e&&t.texSubImage2D(i.TEXTURE_2D,le,0,0,te.width,te.height,pe,O,te.data):t.texImage2D(i.TEXTURE_2D,le,se,te.width,te.height,0,pe,O,te.data);S.generateMipmaps=!1}else _e?(Se&&t.texStorage2D(i.TEXTURE_2D,et,se,ne.width,ne.height),$e&&jt(S,ne,pe,O)):t.texImage2D(i.TEXTURE_2D,0,se,ne.width,ne.height,0,pe,O,ne.data);else if(S.isCompressedTexture)if(S.isCompressedArrayTexture){_e&&Se&&t.texStorage3D(i.TEXTURE_2D_ARRAY,et,se,Te[0].width,Te[0].height,ne.depth);for(let le=0,ze=Te.length;le<ze;le++)if(te=Te[le],S.format!==$i)if(pe!==null)if(_e){if($e)if(S.layerUpdates.size>0){let tt=Bp(te.width,te.height,S.format,S.type);for(let Pe of S.layerUpdates){let ct=te.data.subarray(Pe*tt/te.data.BYTES_PER_ELEMENT,(Pe+1)*tt/te.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,le,0,0,Pe,te.width,te.height,1,pe,ct)}}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,le,0,0,0,te.width,te.height,ne.depth,pe,te.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,le,se,te.width,te.height,ne.depth,0,te.data,0,0);else Ze("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else _e?$e&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,le,0,0,0,te.width,te.height,ne.depth,pe,O,te.data):t.texImage3D(i.TEXTURE_2D_ARRAY,le,se,te.width,te.height,ne.depth,0,pe,O,te.data);S.layerUpdates.size>0&&S.clearLayerUpdates()}else{_e&&Se&&t.texStorage2D(i.TEXTURE_2D,et,se,Te[0].width,Te[0].height);for(let le=0,ze=Te.length;le<ze;le++)te=Te[le],S.format!==$i?pe!==null?_e?$e&&t.compressedTexSubImage2D(i.TEXTURE_2D,le,0,0,te.width,te.height,pe,te.data):t.compressedTexImage2D(i.TEXTURE_2D,le,se,te.width,te.height,0,te.data):Ze("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):_e?$e&&t.texSubImage2D(i.TEXTURE_2D,le,0,0,te.width,te.height,pe,O,te.data):t.texImage2D(i.TEXTURE_2D,le,se,te.width,te.height,0,pe,O,te.data)}else if(S.isDataArrayTexture)if(_e){if(Se&&t.texStorage3D(i.TEXTURE_2D_ARRAY,et,se,ne.width,ne.height,ne.depth),$e)if(S.layerUpdates.size>0){let le=Bp(ne.width,ne.height,S.format,S.type);for(let ze of S.layerUpdates){let tt=ne.data.subarray(ze*le/ne.data.BYTES_PER_ELEMENT,(ze+1)*le/ne.data.BYTES_PER_ELEMENT);t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,ze,ne.width,ne.height,1,pe,O,tt)}S.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,ne.width,ne.height,ne.depth,pe,O,ne.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,se,ne.width,ne.height,ne.depth,0,pe,O,ne.data);else if(S.isData3DTexture)_e?(Se&&t.texStorage3D(i.TEXTURE_3D,et,se,ne.width,ne.height,ne.depth),$e&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,ne.width,ne.height,ne.depth,pe,O,ne.data)):t.texImage3D(i.TEXTURE_3D,0,se,ne.width,ne.height,ne.depth,0,pe,O,ne.data);else if(S.isFramebufferTexture){if(Se)if(_e)t.texStorage2D(i.TEXTURE_2D,et,se,ne.width,ne.height);else{let le=ne.width,ze=ne.height;for(let tt=0;tt<et;tt++)t.texImage2D(i.TEXTURE_2D,tt,se,le,ze,0,pe,O,null),le>>=1,ze>>=1}}else if(S.isHTMLTexture){if("texElementImage2D"in i){let le=i.canvas;if(le.hasAttribute("layoutsubtree")||le.setAttribute("layoutsubtree","true"),ne.parentNode!==le){le.appendChild(ne),u.add(S),le.onpaint=ze=>{let tt=ze.changedElements;for(let Pe of u)tt.includes(Pe.image)&&(Pe.needsUpdate=!0)},le.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,ne);else{let tt=i.RGBA,Pe=i.RGBA,ct=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,tt,Pe,ct,ne)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(Te.length>0){if(_e&&Se){let le=Ye(Te[0]);t.texStorage2D(i.TEXTURE_2D,et,se,le.width,le.height)}for(let le=0,ze=Te.length;le<ze;le++)te=Te[le],_e?$e&&t.texSubImage2D(i.TEXTURE_2D,le,0,0,pe,O,te):t.texImage2D(i.TEXTURE_2D,le,se,pe,O,te);S.generateMipmaps=!1}else if(_e){if(Se){let le=Ye(ne);t.texStorage2D(i.TEXTURE_2D,et,se,le.width,le.height)}$e&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,pe,O,ne)}else t.texImage2D(i.TEXTURE_2D,0,se,pe,O,ne);T(S)&&S.mipmapsAutoUpdate===!0&&b(he),ve.__version=ye.version,S.onUpdate&&S.onUpdate(S)}R.__version=S.version}function cn(R,S,$){if(S.image.length!==6)return;let he=dt(R,S),re=S.source;t.bindTexture(i.TEXTURE_CUBE_MAP,R.__webglTexture,i.TEXTURE0+$);let ye=n.get(re);if(re.version!==ye.__version||he===!0){t.activeTexture(i.TEXTURE0+$);let ve=bt.getPrimaries(bt.workingColorSpace),ee=S.colorSpace===Ns?null:bt.getPrimaries(S.colorSpace),ne=S.colorSpace===Ns||ve===ee?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,S.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),t.pixelStorei(i.UNPACK_ALIGNMENT,S.unpackAlignment),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,ne);let pe=S.isCompressedTexture||S.image[0].isCompressedTexture,O=S.image[0]&&S.image[0].isDataTexture,se=[];for(let Pe=0;Pe<6;Pe++)!pe&&!O?se[Pe]=y(S.image[Pe],!0,s.maxCubemapSize):se[Pe]=O?S.image[Pe].image:S.image[Pe],se[Pe]=He(S,se[Pe]);let te=se[0],Te=r.convert(S.format,S.colorSpace),_e=r.convert(S.type),Se=A(S.internalFormat,Te,_e,S.normalized,S.colorSpace),$e=S.isVideoTexture!==!0,et=ye.__version===void 0||he===!0,le=re.dataReady,ze=M(S,te);mt(i.TEXTURE_CUBE_MAP,S);let tt;if(S.isDepthTexture){if(Se=x(S.format===Ds,S.type),et)if($e)t.texStorage2D(i.TEXTURE_CUBE_MAP,1,Se,te.width,te.height);else for(let Pe=0;Pe<6;Pe++)t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,Se,te.width,te.height,0,Te,_e,null)}else if(pe){$e&&et&&t.texStorage2D(i.TEXTURE_CUBE_MAP,ze,Se,te.width,te.height);for(let Pe=0;Pe<6;Pe++){tt=se[Pe].mipmaps;for(let ct=0;ct<tt.length;ct++){let Wt=tt[ct];S.format!==$i?Te!==null?$e?le&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ct,0,0,Wt.width,Wt.height,Te,Wt.data):t.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ct,Se,Wt.width,Wt.height,0,Wt.data):Ze("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):$e?le&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ct,0,0,Wt.width,Wt.height,Te,_e,Wt.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ct,Se,Wt.width,Wt.height,0,Te,_e,Wt.data)}}}else{if(tt=S.mipmaps,$e&&et){tt.length>0&&ze++;let Pe=Ye(se[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,ze,Se,Pe.width,Pe.height)}for(let Pe=0;Pe<6;Pe++)if(O){$e?le&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,0,0,se[Pe].width,se[Pe].height,Te,_e,se[Pe].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,Se,se[Pe].width,se[Pe].height,0,Te,_e,se[Pe].data);for(let ct=0;ct<tt.length;ct++){let Gn=tt[ct].image[Pe].image;$e?le&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ct+1,0,0,Gn.width,Gn.height,Te,_e,Gn.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ct+1,Se,Gn.width,Gn.height,0,Te,_e,Gn.data)}}else{$e?le&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,0,0,Te,_e,se[Pe]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,Se,Te,_e,se[Pe]);for(let ct=0;ct<tt.length;ct++){let Wt=tt[ct];$e?le&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ct+1,0,0,Te,_e,Wt.image[Pe]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ct+1,Se,Te,_e,Wt.image[Pe])}}}T(S)&&S.mipmapsAutoUpdate===!0&&b(i.TEXTURE_CUBE_MAP),ye.__version=re.version,S.onUpdate&&S.onUpdate(S)}R.__version=S.version}function kt(R,S,$,he,re,ye){let ve=r.convert($.format,$.colorSpace),ee=r.convert($.type),ne=A($.internalFormat,ve,ee,$.normalized,$.colorSpace),pe=n.get(S),O=n.get($);if(O.__renderTarget=S,!pe.__hasExternalTextures){let se=Math.max(1,S.width>>ye),te=Math.max(1,S.height>>ye);re===i.TEXTURE_3D||re===i.TEXTURE_2D_ARRAY?t.texImage3D(re,ye,ne,se,te,S.depth,0,ve,ee,null):t.texImage2D(re,ye,ne,se,te,0,ve,ee,null)}t.bindFramebuffer(i.FRAMEBUFFER,R),Ee(S)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,he,re,O.__webglTexture,0,lt(S)):(re===i.TEXTURE_2D||re>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&re<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,he,re,O.__webglTexture,ye),t.bindFramebuffer(i.FRAMEBUFFER,null)}function Cn(R,S,$){if(i.bindRenderbuffer(i.RENDERBUFFER,R),S.depthBuffer){let he=S.depthTexture,re=he&&he.isDepthTexture?he.type:null,ye=x(S.stencilBuffer,re),ve=S.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;Ee(S)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,lt(S),ye,S.width,S.height):$?i.renderbufferStorageMultisample(i.RENDERBUFFER,lt(S),ye,S.width,S.height):i.renderbufferStorage(i.RENDERBUFFER,ye,S.width,S.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,ve,i.RENDERBUFFER,R)}else{let he=S.textures;for(let re=0;re<he.length;re++){let ye=he[re],ve=r.convert(ye.format,ye.colorSpace),ee=r.convert(ye.type),ne=A(ye.internalFormat,ve,ee,ye.normalized,ye.colorSpace);Ee(S)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,lt(S),ne,S.width,S.height):$?i.renderbufferStorageMultisample(i.RENDERBUFFER,lt(S),ne,S.width,S.height):i.renderbufferStorage(i.RENDERBUFFER,ne,S.width,S.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function wt(R,S,$){let he=S.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(i.FRAMEBUFFER,R),!(S.depthTexture&&S.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let re=n.get(S.depthTexture);re.__renderTarget=S;let ye=he?S.depthTexture.image[0]:S.depthTexture.image;(!re.__webglTexture||ye.width!==S.width||ye.height!==S.height)&&(ye.width=S.width,ye.height=S.height,S.depthTexture.needsUpdate=!0),he?we(S.depthTexture,0):ge(S.depthTexture,0);let ve=re.__webglTexture,ee=lt(S),ne=he?i.TEXTURE_CUBE_MAP_POSITIVE_X+$:i.TEXTURE_2D,pe=S.depthTexture.format===Ds?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(S.depthTexture.format===As)Ee(S)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,pe,ne,ve,0,ee):i.framebufferTexture2D(i.FRAMEBUFFER,pe,ne,ve,0);else if(S.depthTexture.format===Ds)Ee(S)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,pe,ne,ve,0,ee):i.framebufferTexture2D(i.FRAMEBUFFER,pe,ne,ve,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function yn(R){let S=n.get(R),$=R.isWebGLCubeRenderTarget===!0;if(S.__boundDepthTexture!==R.depthTexture){let he=R.depthTexture;if(S.__depthDisposeCallback&&S.__depthDisposeCallback(),he){let re=()=>{delete S.__boundDepthTexture,delete S.__depthDisposeCallback,he.removeEventListener("dispose",re)};he.addEventListener("dispose",re),S.__depthDisposeCallback=re}S.__boundDepthTexture=he}if(R.depthTexture&&!S.__autoAllocateDepthBuffer)if($)for(let he=0;he<6;he++)wt(S.__webglFramebuffer[he],R,he);else R.texture.mipmaps.length>0?wt(S.__webglFramebuffer[0],R,0):wt(S.__webglFramebuffer,R,0);else if($){S.__webglDepthbuffer=[];for(let he=0;he<6;he++)if(t.bindFramebuffer(i.FRAMEBUFFER,S.__webglFramebuffer[he]),S.__webglDepthbuffer[he]===void 0)S.__webglDepthbuffer[he]=i.createRenderbuffer(),Cn(S.__webglDepthbuffer[he],R,!1);else{let re=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ye=S.__webglDepthbuffer[he];i.bindRenderbuffer(i.RENDERBUFFER,ye),i.framebufferRenderbuffer(i.FRAMEBUFFER,re,i.RENDERBUFFER,ye)}}else if(R.texture.mipmaps.length>0?t.bindFramebuffer(i.FRAMEBUFFER,S.__webglFramebuffer[0]):t.bindFramebuffer(i.FRAMEBUFFER,S.__webglFramebuffer),S.__webglDepthbuffer===void 0)S.__webglDepthbuffer=i.createRenderbuffer(),Cn(S.__webglDepthbuffer,R,!1);else{let re=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ye=S.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,ye),i.framebufferRenderbuffer(i.FRAMEBUFFER,re,i.RENDERBUFFER,ye)}t.bindFramebuffer(i.FRAMEBUFFER,null)}function en(R,S,$){let he=n.get(R);S!==void 0&&kt(he.__webglFramebuffer,R,R.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),$!==void 0&&yn(R)}function hn(R){let S=R.texture,$=n.get(R),he=n.get(S);R.addEventListener("dispose",V),k(R);let re=R.textures,ye=R.isWebGLCubeRenderTarget===!0,ve=re.length>1;if(ve||(he.__webglTexture===void 0&&(he.__webglTexture=i.createTexture()),he.__version=S.version,o.memory.textures++),ye){$.__webglFramebuffer=[];for(let ee=0;ee<6;ee++)if(S.mipmaps.length>0){$.__webglFramebuffer[ee]=[];for(let ne=0;ne<S.mipmaps.length;ne++)$.__webglFramebuffer[ee][ne]=i.createFramebuffer()}else $.__webglFramebuffer[ee]=i.createFramebuffer()}else{if(S.mipmaps.length>0){$.__webglFramebuffer=[];for(let ee=0;ee<S.mipmaps.length;ee++)$.__webglFramebuffer[ee]=i.createFramebuffer()}else $.__webglFramebuffer=i.createFramebuffer();if(ve)for(let ee=0,ne=re.length;ee<ne;ee++){let pe=n.get(re[ee]);pe.__webglTexture===void 0&&(pe.__webglTexture=i.createTexture(),o.memory.textures++)}if(R.samples>0&&Ee(R)===!1){$.__webglMultisampledFramebuffer=i.createFramebuffer(),$.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,$.__webglMultisampledFramebuffer);for(let ee=0;ee<re.length;ee++){let ne=re[ee];$.__webglColorRenderbuffer[ee]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,$.__webglColorRenderbuffer[ee]);let pe=r.convert(ne.format,ne.colorSpace),O=r.convert(ne.type),se=A(ne.internalFormat,pe,O,ne.normalized,ne.colorSpace,R.isXRRenderTarget===!0),te=lt(R);i.renderbufferStorageMultisample(i.RENDERBUFFER,te,se,R.width,R.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+ee,i.RENDERBUFFER,$.__webglColorRenderbuffer[ee])}i.bindRenderbuffer(i.RENDERBUFFER,null),R.depthBuffer&&($.__webglDepthRenderbuffer=i.createRenderbuffer(),Cn($.__webglDepthRenderbuffer,R,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(ye){t.bindTexture(i.TEXTURE_CUBE_MAP,he.__webglTexture),mt(i.TEXTURE_CUBE_MAP,S);for(let ee=0;ee<6;ee++)if(S.mipmaps.length>0)for(let ne=0;ne<S.mipmaps.length;ne++)kt($.__webglFramebuffer[ee][ne],R,S,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+ee,ne);else kt($.__webglFramebuffer[ee],R,S,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+ee,0);T(S)?b(i.TEXTURE_CUBE_MAP):S.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),t.unbindTexture()}else if(ve){for(let ee=0,ne=re.length;ee<ne;ee++){let pe=re[ee],O=n.get(pe),se=i.TEXTURE_2D;(R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(se=R.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(se,O.__webglTexture),mt(se,pe),kt($.__webglFramebuffer,R,pe,i.COLOR_ATTACHMENT0+ee,se,0),T(pe)&&b(se)}t.unbindTexture()}else{let ee=i.TEXTURE_2D;if((R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(ee=R.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(ee,he.__webglTexture),mt(ee,S),S.mipmaps.length>0)for(let ne=0;ne<S.mipmaps.length;ne++)kt($.__webglFramebuffer[ne],R,S,i.COLOR_ATTACHMENT0,ee,ne);else kt($.__webglFramebuffer,R,S,i.COLOR_ATTACHMENT0,ee,0);T(S)?b(ee):S.mipmaps.length>0&&i.texParameteri(ee,i.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),t.unbindTexture()}R.depthBuffer&&yn(R)}function F(R){let S=R.textures;for(let $=0,he=S.length;$<he;$++){let re=S[$];if(T(re)&&re.mipmapsAutoUpdate===!0){let ye=C(R),ve=n.get(re).__webglTexture;t.bindTexture(ye,ve),b(ye),t.unbindTexture()}}}let Ie=[];function Je(R){if(R.samples>0){if(Ee(R)===!1){let S=R.textures,$=R.width,he=R.height,re=i.COLOR_BUFFER_BIT,ye=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ve=n.get(R),ee=S.length>1;if(ee)for(let pe=0;pe<S.length;pe++)t.bindFramebuffer(i.FRAMEBUFFER,ve.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+pe,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,ve.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+pe,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,ve.__webglMultisampledFramebuffer),R.texture.mipmaps.length>0?t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ve.__webglFramebuffer[0]):t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ve.__webglFramebuffer);for(let pe=0;pe<S.length;pe++){if(R.resolveDepthBuffer&&(R.depthBuffer&&(re|=i.DEPTH_BUFFER_BIT),R.stencilBuffer&&R.resolveStencilBuffer&&(re|=i.STENCIL_BUFFER_BIT)),ee){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,ve.__webglColorRenderbuffer[pe]);let O=n.get(S[pe]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,O,0)}i.blitFramebuffer(0,0,$,he,0,0,$,he,re,i.NEAREST),l===!0&&(Ie.length=0,Ie.push(i.COLOR_ATTACHMENT0+pe),R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&Ie.push(ye),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,Ie))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),ee)for(let pe=0;pe<S.length;pe++){t.bindFramebuffer(i.FRAMEBUFFER,ve.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+pe,i.RENDERBUFFER,ve.__webglColorRenderbuffer[pe]);let O=n.get(S[pe]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,ve.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+pe,i.TEXTURE_2D,O,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ve.__webglMultisampledFramebuffer)}else if(R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&l){let S=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[S])}}}function lt(R){return Math.min(s.maxSamples,R.samples)}function Ee(R){let S=n.get(R);return R.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&S.__useRenderToTexture!==!1}function zt(R){let S=o.render.frame;h.get(R)!==S&&(h.set(R,S),R.update())}function He(R,S){let $=R.colorSpace,he=R.format,re=R.type;return R.isCompressedTexture===!0||R.isVideoTexture===!0||$!==Va&&$!==Ns&&(bt.getTransfer($)===Dt?(he!==$i||re!==ei)&&Ze("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):Qe("WebGLTextures: Unsupported texture color space:",$)),S}function Ye(R){return typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement?(c.width=R.naturalWidth||R.width,c.height=R.naturalHeight||R.height):typeof VideoFrame<"u"&&R instanceof VideoFrame?(c.width=R.displayWidth,c.height=R.displayHeight):(c.width=R.width,c.height=R.height),c}this.allocateTextureUnit=ue,this.resetTextureUnits=K,this.getTextureUnits=ie,this.setTextureUnits=de,this.setTexture2D=ge,this.setTexture2DArray=xe,this.setTexture3D=Re,this.setTextureCube=we,this.rebindTextures=en,this.setupRenderTarget=hn,this.updateRenderTargetMipmap=F,this.updateMultisampleRenderTarget=Je,this.setupDepthRenderbuffer=yn,this.setupFrameBufferTexture=kt,this.useMultisampledRTT=Ee,this.dispose=G}function KC(i,e){function t(n,s=Ns){let r,o=bt.getTransfer(s);if(n===ei)return i.UNSIGNED_BYTE;if(n===iu)return i.UNSIGNED_SHORT_4_4_4_4;if(n===su)return i.UNSIGNED_SHORT_5_5_5_1;if(n===vp)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===bp)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===yp)return i.BYTE;if(n===xp)return i.SHORT;if(n===Yo)return i.UNSIGNED_SHORT;if(n===nu)return i.INT;if(n===Gi)return i.UNSIGNED_INT;if(n===Hi)return i.FLOAT;if(n===Wi)return i.HALF_FLOAT;if(n===Sp)return i.ALPHA;if(n===Mp)return i.RGB;if(n===$i)return i.RGBA;if(n===As)return i.DEPTH_COMPONENT;if(n===Ds)return i.DEPTH_STENCIL;if(n===wp)return i.RED;if(n===ru)return i.RED_INTEGER;if(n===hr)return i.RG;if(n===ou)return i.RG_INTEGER;if(n===au)return i.RGBA_INTEGER;if(n===xl||n===vl||n===bl||n===Sl)if(o===Dt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===xl)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===vl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===bl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===Sl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===xl)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===vl)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===bl)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===Sl)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===lu||n===cu||n===hu||n===uu)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===lu)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===cu)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===hu)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===uu)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===du||n===fu||n===pu||n===mu||n===gu||n===Ml||n===_u)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(n===du||n===fu)return o===Dt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===pu)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===mu)return r.COMPRESSED_R11_EAC;if(n===gu)return r.COMPRESSED_SIGNED_R11_EAC;if(n===Ml)return r.COMPRESSED_RG11_EAC;if(n===_u)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===yu||n===xu||n===vu||n===bu||n===Su||n===Mu||n===wu||n===Eu||n===Tu||n===Au||n===Cu||n===Ru||n===Pu||n===Iu)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(n===yu)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===xu)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===vu)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===bu)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===Su)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===Mu)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===wu)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===Eu)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===Tu)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===Au)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===Cu)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===Ru)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===Pu)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===Iu)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===Lu||n===Du||n===Nu)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(n===Lu)return o===Dt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===Du)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===Nu)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===Uu||n===Ou||n===wl||n===Fu)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(n===Uu)return r.COMPRESSED_RED_RGTC1_EXT;if(n===Ou)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===wl)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===Fu)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===kr?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:t}}var QC=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,eR=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,Yp=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let n=new Qa(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=n}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,n=new ls({vertexShader:QC,fragmentShader:eR,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new Mt(new sl(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Zp=class extends Bi{constructor(e,t){super();let n=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,h=null,u=null,d=null,f=null,p=null,_=typeof XRWebGLBinding<"u",m=new Yp,g={},y=t.getContextAttributes(),T=null,b=null,C=[],A=[],x=new Me,M=null,k=null,N=new Zn;N.viewport=new Kt;let D=new Zn;D.viewport=new Kt;let V=[N,D],W=new Jh,U=null,G=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(Q){let ge=C[Q];return ge===void 0&&(ge=new Bo,C[Q]=ge),ge.getTargetRaySpace()},this.getControllerGrip=function(Q){let ge=C[Q];return ge===void 0&&(ge=new Bo,C[Q]=ge),ge.getGripSpace()},this.getHand=function(Q){let ge=C[Q];return ge===void 0&&(ge=new Bo,C[Q]=ge),ge.getHandSpace()};function Z(Q){let ge=A.indexOf(Q.inputSource);if(ge===-1)return;let xe=C[ge];xe!==void 0&&(xe.update(Q.inputSource,Q.frame,c||o),xe.dispatchEvent({type:Q.type,data:Q.inputSource}))}function z(){s.removeEventListener("select",Z),s.removeEventListener("selectstart",Z),s.removeEventListener("selectend",Z),s.removeEventListener("squeeze",Z),s.removeEventListener("squeezestart",Z),s.removeEventListener("squeezeend",Z),s.removeEventListener("end",z),s.removeEventListener("inputsourceschange",ce);for(let Q=0;Q<C.length;Q++){let ge=A[Q];ge!==null&&(A[Q]=null,C[Q].disconnect(ge))}U=null,G=null,m.reset();for(let Q in g)delete g[Q];if(e.setRenderTarget(T),f=null,d=null,u=null,s=null,b=null,ue.stop(),n.isPresenting=!1,e.setPixelRatio(M),e.setSize(x.width,x.height,!1),k!==null){let Q=k.camera;Q.fov=k.fov,Q.zoom=k.zoom,Q.updateProjectionMatrix(),k=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(Q){r=Q,n.isPresenting===!0&&Ze("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(Q){a=Q,n.isPresenting===!0&&Ze("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(Q){c=Q},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return u===null&&_&&(u=new XRWebGLBinding(s,t)),u},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(Q){if(s=Q,s!==null){if(T=e.getRenderTarget(),s.addEventListener("select",Z),s.addEventListener("selectstart",Z),s.addEventListener("selectend",Z),s.addEventListener("squeeze",Z),s.addEventListener("squeezestart",Z),s.addEventListener("squeezeend",Z),s.addEventListener("end",z),s.addEventListener("inputsourceschange",ce),y.xrCompatible!==!0&&await t.makeXRCompatible(),M=e.getPixelRatio(),e.getSize(x),_&&"createProjectionLayer"in XRWebGLBinding.prototype){let xe=null,Re=null,we=null;y.depth&&(we=y.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,xe=y.stencil?Ds:As,Re=y.stencil?kr:Gi);let qe={colorFormat:t.RGBA8,depthFormat:we,scaleFactor:r};u=this.getBinding(),d=u.createProjectionLayer(qe),s.updateRenderState({layers:[d]}),e.setPixelRatio(1),e.setSize(d.textureWidth,d.textureHeight,!1),b=new mi(d.textureWidth,d.textureHeight,{format:$i,type:ei,depthTexture:new Ps(d.textureWidth,d.textureHeight,Re,void 0,void 0,void 0,void 0,void 0,void 0,xe),stencilBuffer:y.stencil,colorSpace:e.outputColorSpace,samples:y.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let xe={antialias:y.antialias,alpha:!0,depth:y.depth,stencil:y.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,t,xe),s.updateRenderState({baseLayer:f}),e.setPixelRatio(1),e.setSize(f.framebufferWidth,f.framebufferHeight,!1),b=new mi(f.framebufferWidth,f.framebufferHeight,{format:$i,type:ei,colorSpace:e.outputColorSpace,stencilBuffer:y.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}b.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),ue.setContext(s),ue.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function ce(Q){for(let ge=0;ge<Q.removed.length;ge++){let xe=Q.removed[ge],Re=A.indexOf(xe);Re>=0&&(A[Re]=null,C[Re].disconnect(xe))}for(let ge=0;ge<Q.added.length;ge++){let xe=Q.added[ge],Re=A.indexOf(xe);if(Re===-1){for(let qe=0;qe<C.length;qe++)if(qe>=A.length){A.push(xe),Re=qe;break}else if(A[qe]===null){A[qe]=xe,Re=qe;break}if(Re===-1)break}let we=C[Re];we&&we.connect(xe)}}function j(Q,ge){ge===null?Q.matrixWorld.copy(Q.matrix):Q.matrixWorld.multiplyMatrices(ge.matrixWorld,Q.matrix),Q.matrixWorldInverse.copy(Q.matrixWorld).invert()}this.updateCamera=function(Q){if(s===null)return;let ge=Q.near,xe=Q.far;m.texture!==null&&(m.depthNear>0&&(ge=m.depthNear),m.depthFar>0&&(xe=m.depthFar)),W.near=D.near=N.near=ge,W.far=D.far=N.far=xe,(U!==W.near||G!==W.far)&&(s.updateRenderState({depthNear:W.near,depthFar:W.far}),U=W.near,G=W.far),W.layers.mask=Q.layers.mask|6,N.layers.mask=W.layers.mask&-5,D.layers.mask=W.layers.mask&-3;let Re=Q.parent,we=W.cameras;j(W,Re);for(let qe=0;qe<we.length;qe++)j(we[qe],Re);W.projectionMatrix.copy(N.projectionMatrix),W.projectionMatrixInverse.copy(N.projectionMatrixInverse),k===null&&Q.isPerspectiveCamera&&(k={camera:Q,fov:Q.fov,zoom:Q.zoom}),K(Q,W,Re)};function K(Q,ge,xe){xe===null?Q.matrix.copy(ge.matrixWorld):(Q.matrix.copy(xe.matrixWorld),Q.matrix.invert(),Q.matrix.multiply(ge.matrixWorld)),Q.matrix.decompose(Q.position,Q.quaternion,Q.scale),Q.updateMatrixWorld(!0),Q.projectionMatrix.copy(ge.projectionMatrix),Q.projectionMatrixInverse.copy(ge.projectionMatrixInverse),Q.isPerspectiveCamera&&(Q.fov=Oo*2*Math.atan(1/Q.projectionMatrix.elements[5]),Q.zoom=1)}this.getCamera=function(){return W},this.getFoveation=function(){if(!(d===null&&f===null))return l},this.setFoveation=function(Q){l=Q,d!==null&&(d.fixedFoveation=Q),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=Q)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(W)},this.getCameraTexture=function(Q){return g[Q]};let ie=null;function de(Q,ge){if(h=ge.getViewerPose(c||o),p=ge,h!==null){let xe=h.views;f!==null&&(e.setRenderTargetFramebuffer(b,f.framebuffer),e.setRenderTarget(b));let Re=!1;xe.length!==W.cameras.length&&(W.cameras.length=0,Re=!0);for(let We=0;We<xe.length;We++){let mt=xe[We],dt=null;if(f!==null)dt=f.getViewport(mt);else{let jt=u.getViewSubImage(d,mt);dt=jt.viewport,We===0&&(e.setRenderTargetTextures(b,jt.colorTexture,jt.depthStencilTexture),e.setRenderTarget(b))}let rt=V[We];rt===void 0&&(rt=new Zn,rt.layers.enable(We),rt.viewport=new Kt,V[We]=rt),rt.matrix.fromArray(mt.transform.matrix),rt.matrix.decompose(rt.position,rt.quaternion,rt.scale),rt.projectionMatrix.fromArray(mt.projectionMatrix),rt.projectionMatrixInverse.copy(rt.projectionMatrix).invert(),rt.viewport.set(dt.x,dt.y,dt.width,dt.height),We===0&&(W.matrix.copy(rt.matrix),W.matrix.decompose(W.position,W.quaternion,W.scale)),Re===!0&&W.cameras.push(rt)}let we=s.enabledFeatures;if(we&&we.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&_){u=n.getBinding();let We=u.getDepthInformation(xe[0]);We&&We.isValid&&We.texture&&m.init(We,s.renderState)}if(we&&we.includes("camera-access")&&_){e.state.unbindTexture(),u=n.getBinding();for(let We=0;We<xe.length;We++){let mt=xe[We].camera;if(mt){let dt=g[mt];dt||(dt=new Qa,g[mt]=dt);let rt=u.getCameraImage(mt);dt.sourceTexture=rt}}}}for(let xe=0;xe<C.length;xe++){let Re=A[xe],we=C[xe];Re!==null&&we!==void 0&&we.update(Re,ge,c||o)}ie&&ie(Q,ge),ge.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:ge}),p=null}let ue=new Dx;ue.setAnimationLoop(de),this.setAnimationLoop=function(Q){ie=Q},this.dispose=function(){}}},tR=new St,Hx=new st;Hx.set(-1,0,0,0,1,0,0,0,1);function nR(i,e){function t(m,g){m.matrixAutoUpdate===!0&&m.updateMatrix(),g.value.copy(m.matrix)}function n(m,g){g.color.getRGB(m.fogColor.value,Op(i)),g.isFog?(m.fogNear.value=g.near,m.fogFar.value=g.far):g.isFogExp2&&(m.fogDensity.value=g.density)}function s(m,g,y,T,b){g.isNodeMaterial?g.uniformsNeedUpdate=!1:g.isMeshBasicMaterial?r(m,g):g.isMeshLambertMaterial?(r(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshToonMaterial?(r(m,g),u(m,g)):g.isMeshPhongMaterial?(r(m,g),h(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshStandardMaterial?(r(m,g),d(m,g),g.isMeshPhysicalMaterial&&f(m,g,b)):g.isMeshMatcapMaterial?(r(m,g),p(m,g)):g.isMeshDepthMaterial?r(m,g):g.isMeshDistanceMaterial?(r(m,g),_(m,g)):g.isMeshNormalMaterial?r(m,g):g.isLineBasicMaterial?(o(m,g),g.isLineDashedMaterial&&a(m,g)):g.isPointsMaterial?l(m,g,y,T):g.isSpriteMaterial?c(m,g):g.isShadowMaterial?(m.color.value.copy(g.color),m.opacity.value=g.opacity):g.isShaderMaterial&&(g.uniformsNeedUpdate=!1)}function r(m,g){m.opacity.value=g.opacity,g.color&&m.diffuse.value.copy(g.color),g.emissive&&m.emissive.value.copy(g.emissive).multiplyScalar(g.emissiveIntensity),g.map&&(m.map.value=g.map,t(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,t(g.alphaMap,m.alphaMapTransform)),g.bumpMap&&(m.bumpMap.value=g.bumpMap,t(g.bumpMap,m.bumpMapTransform),m.bumpScale.value=g.bumpScale,g.side===Kn&&(m.bumpScale.value*=-1)),g.normalMap&&(m.normalMap.value=g.normalMap,t(g.normalMap,m.normalMapTransform),m.normalScale.value.copy(g.normalScale),g.side===Kn&&m.normalScale.value.negate()),g.displacementMap&&(m.displacementMap.value=g.displacementMap,t(g.displacementMap,m.displacementMapTransform),m.displacementScale.value=g.displacementScale,m.displacementBias.value=g.displacementBias),g.emissiveMap&&(m.emissiveMap.value=g.emissiveMap,t(g.emissiveMap,m.emissiveMapTransform)),g.specularMap&&(m.specularMap.value=g.specularMap,t(g.specularMap,m.specularMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest);let y=e.get(g),T=y.envMap,b=y.envMapRotation;T&&(m.envMap.value=T,m.envMapRotation.value.setFromMatrix4(tR.makeRotationFromEuler(b)).transpose(),T.isCubeTexture&&T.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(Hx),m.reflectivity.value=g.reflectivity,m.ior.value=g.ior,m.refractionRatio.value=g.refractionRatio),g.lightMap&&(m.lightMap.value=g.lightMap,m.lightMapIntensity.value=g.lightMapIntensity,t(g.lightMap,m.lightMapTransform)),g.aoMap&&(m.aoMap.value=g.aoMap,m.aoMapIntensity.value=g.aoMapIntensity,t(g.aoMap,m.aoMapTransform))}function o(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,g.map&&(m.map.value=g.map,t(g.map,m.mapTransform))}function a(m,g){m.dashSize.value=g.dashSize,m.totalSize.value=g.dashSize+g.gapSize,m.scale.value=g.scale}function l(m,g,y,T){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.size.value=g.size*y,m.scale.value=T*.5,g.map&&(m.map.value=g.map,t(g.map,m.uvTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,t(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function c(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.rotation.value=g.rotation,g.map&&(m.map.value=g.map,t(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,t(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function h(m,g){m.specular.value.copy(g.specular),m.shininess.value=Math.max(g.shininess,1e-4)}function u(m,g){g.gradientMap&&(m.gradientMap.value=g.gradientMap)}function d(m,g){m.metalness.value=g.metalness,g.metalnessMap&&(m.metalnessMap.value=g.metalnessMap,t(g.metalnessMap,m.metalnessMapTransform)),m.roughness.value=g.roughness,g.roughnessMap&&(m.roughnessMap.value=g.roughnessMap,t(g.roughnessMap,m.roughnessMapTransform)),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)}function f(m,g,y){m.ior.value=g.ior,g.diffuseRoughness>0&&(m.diffuseRoughness.value=g.diffuseRoughness,g.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=g.diffuseRoughnessMap,t(g.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),g.sheen>0&&(m.sheenColor.value.copy(g.sheenColor).multiplyScalar(g.sheen),m.sheenRoughness.value=g.sheenRoughness,g.sheenColorMap&&(m.sheenColorMap.value=g.sheenColorMap,t(g.sheenColorMap,m.sheenColorMapTransform)),g.sheenRoughnessMap&&(m.sheenRoughnessMap.value=g.sheenRoughnessMap,t(g.sheenRoughnessMap,m.sheenRoughnessMapTransform))),g.clearcoat>0&&(m.clearcoat.value=g.clearcoat,m.clearcoatRoughness.value=g.clearcoatRoughness,g.clearcoatMap&&(m.clearcoatMap.value=g.clearcoatMap,t(g.clearcoatMap,m.clearcoatMapTransform)),g.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=g.clearcoatRoughnessMap,t(g.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),g.clearcoatNormalMap&&(m.clearcoatNormalMap.value=g.clearcoatNormalMap,t(g.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(g.clearcoatNormalScale),g.side===Kn&&m.clearcoatNormalScale.value.negate())),g.dispersion>0&&(m.dispersion.value=g.dispersion),g.retroreflectivity>0&&(m.retroreflectivity.value=g.retroreflectivity),g.iridescence>0&&(m.iridescence.value=g.iridescence,m.iridescenceIOR.value=g.iridescenceIOR,m.iridescenceThicknessMinimum.value=g.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=g.iridescenceThicknessMaximum,g.iridescenceMap&&(m.iridescenceMap.value=g.iridescenceMap,t(g.iridescenceMap,m.iridescenceMapTransform)),g.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=g.iridescenceThicknessMap,t(g.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),g.transmission>0&&(m.transmission.value=g.transmission,m.transmissionSamplerMap.value=y.texture,m.transmissionSamplerSize.value.set(y.width,y.height),g.transmissionMap&&(m.transmissionMap.value=g.transmissionMap,t(g.transmissionMap,m.transmissionMapTransform)),m.thickness.value=g.thickness,g.thicknessMap&&(m.thicknessMap.value=g.thicknessMap,t(g.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=g.attenuationDistance,m.attenuationColor.value.copy(g.attenuationColor)),g.anisotropy>0&&(m.anisotropyVector.value.set(g.anisotropy*Math.cos(g.anisotropyRotation),g.anisotropy*Math.sin(g.anisotropyRotation)),g.anisotropyMap&&(m.anisotropyMap.value=g.anisotropyMap,t(g.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=g.specularIntensity,m.specularColor.value.copy(g.specularColor),g.specularColorMap&&(m.specularColorMap.value=g.specularColorMap,t(g.specularColorMap,m.specularColorMapTransform)),g.specularIntensityMap&&(m.specularIntensityMap.value=g.specularIntensityMap,t(g.specularIntensityMap,m.specularIntensityMapTransform))}function p(m,g){g.matcap&&(m.matcap.value=g.matcap)}function _(m,g){let y=e.get(g).light;m.referencePosition.value.setFromMatrixPosition(y.matrixWorld),m.nearDistance.value=y.shadow.camera.near,m.farDistance.value=y.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function iR(i,e,t,n){let s={},r={};function o(y,T){let b=T.program;n.uniformBlockBinding(y,b,s[y.id])}function a(y,T){let b=s[y.id];b===void 0&&(p(y),b=l(y),s[y.id]=b,y.addEventListener("dispose",m));let C=T.program;n.updateUBOMapping(y,C);let A=e.render.frame;r[y.id]!==A&&(c(y),r[y.id]=A)}function l(y){let T=i.createBuffer(),b=y.__size,C=y.usage;return i.bindBuffer(i.UNIFORM_BUFFER,T),i.bufferData(i.UNIFORM_BUFFER,b,C),i.bindBuffer(i.UNIFORM_BUFFER,null),T}function c(y){let T=s[y.id],b=y.uniforms,C=y.__cache;i.bindBuffer(i.UNIFORM_BUFFER,T);for(let A=0,x=b.length;A<x;A++){let M=b[A];if(Array.isArray(M))for(let k=0,N=M.length;k<N;k++)h(M[k],A,k,C);else h(M,A,0,C)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function h(y,T,b,C){if(d(y,T,b,C)===!0){let A=y.__offset,x=y.value;if(Array.isArray(x)){let M=0;for(let k=0;k<x.length;k++){let N=x[k],D=_(N,!0);u(N,y.__data,M),M+=D.storage/Float32Array.BYTES_PER_ELEMENT}}else u(x,y.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,A,y.__data)}}function u(y,T,b){typeof y=="number"||typeof y=="boolean"?T[b]=y:y.isMatrix3?(T[b]=y.elements[0],T[b+1]=y.elements[1],T[b+2]=y.elements[2],T[b+3]=0,T[b+4]=y.elements[3],T[b+5]=y.elements[4],T[b+6]=y.elements[5],T[b+7]=0,T[b+8]=y.elements[6],T[b+9]=y.elements[7],T[b+10]=y.elements[8],T[b+11]=0):ArrayBuffer.isView(y)?T.set(y.subarray(0,T.length-b),b):y.toArray(T,b)}function d(y,T,b,C){let A=y.value,x=T+"_"+b;if(Array.isArray(A)){C[x]===void 0&&(C[x]=[]);let M=C[x],k=!1;for(let N=0;N<A.length;N++)f(A[N],M,N)===!0&&(k=!0);return k}return f(A,C,x)}function f(y,T,b){if(T[b]===void 0)return typeof y=="number"||typeof y=="boolean"?T[b]=y:ArrayBuffer.isView(y)?T[b]=y.slice():T[b]=y.clone(),!0;{let C=T[b];if(typeof y=="number"||typeof y=="boolean"){if(C!==y)return T[b]=y,!0}else{if(ArrayBuffer.isView(y))return!0;if(C.equals(y)===!1)return C.copy(y),!0}}return!1}function p(y){let T=y.uniforms,b=0,C=16;for(let x=0,M=T.length;x<M;x++){let k=Array.isArray(T[x])?T[x]:[T[x]];for(let N=0,D=k.length;N<D;N++){let V=k[N],W=Array.isArray(V.value)?V.value:[V.value],U=Array.isArray(T[x])||Array.isArray(V.value),G=b;for(let z=0,ce=W.length;z<ce;z++){let j=W[z],K=_(j,U),ie=b%C,de=ie%K.boundary,ue=ie+de;b+=de,ue!==0&&C-ue<K.storage&&(b+=C-ue),z===0&&(G=b),b+=K.storage}let Z=V.type==="int"?Int32Array:V.type==="uint"?Uint32Array:Float32Array;V.__data=new Z((b-G)/Float32Array.BYTES_PER_ELEMENT),V.__offset=G}}let A=b%C;return A>0&&(b+=C-A),y.__size=b,y.__cache={},this}function _(y,T){let b={boundary:0,storage:0};return typeof y=="number"||typeof y=="boolean"?(b.boundary=4,b.storage=4):y.isVector2?(b.boundary=8,b.storage=8):y.isVector3||y.isColor?(b.boundary=16,b.storage=12):y.isVector4?(b.boundary=16,b.storage=16):y.isMatrix3?(b.boundary=16,b.storage=48):y.isMatrix4?(b.boundary=16,b.storage=64):y.isTexture?Ze("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(y)?(b.boundary=16,b.storage=y.byteLength):Ze("WebGLRenderer: Unsupported uniform value type.",y),T===!0&&(b.boundary=16,b.storage=Math.ceil(b.storage/16)*16),b}function m(y){let T=y.target;T.removeEventListener("dispose",m),i.deleteBuffer(s[T.id]),delete s[T.id],delete r[T.id]}function g(){for(let y in s)i.deleteBuffer(s[y]);s={},r={}}return{bind:o,update:a,dispose:g}}var sR=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),hs=null;function rR(){return hs===null&&(hs=new Eh(sR,16,16,hr,Wi),hs.name="DFG_LUT",hs.minFilter=jn,hs.magFilter=jn,hs.wrapS=os,hs.wrapT=os,hs.generateMipmaps=!1,hs.needsUpdate=!0),hs}var Gu=class{constructor(e={}){let{canvas:t=ix(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:d=!1,outputBufferType:f=ei}=e;this.isWebGLRenderer=!0;let p;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=n.getContextAttributes().alpha}else p=o;let _=f,m=new Set([au,ou,ru]),g=new Set([ei,Gi,Yo,kr,iu,su]),y=new Uint32Array(4),T=new Int32Array(4),b={textures:[],min:[],max:[],resolution:[]},C=null,A=null,x=[],M=[],k=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=cs,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let N=this,D=!1,V=null,W=null,U=null,G=null;this._outputColorSpace=di;let Z=0,z=0,ce=null,j=-1,K=null,ie=new Kt,de=new Kt,ue=null,Q=new it(0),ge=0,xe=t.width,Re=t.height,we=1,qe=null,at=null,We=new Kt(0,0,xe,Re),mt=new Kt(0,0,xe,Re),dt=!1,rt=new tr,jt=new Th,Ht=!1,cn=!1,kt=new St,Cn=new I,wt=new Kt,yn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},en=!1;function hn(){return ce===null?we:1}let F=n;function Ie(E,B){return t.getContext(E,B)}let Je,lt,Ee,zt,He,Ye,R,S,$,he,re,ye,ve,ee,ne,pe,O,se,te,Te,_e,Se,$e;try{let E={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",ze,!1),t.addEventListener("webglcontextrestored",tt,!1),t.addEventListener("webglcontextcreationerror",Pe,!1),F===null){let B="webgl2";if(F=Ie(B,E),F===null)throw Ie(B)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}et()}catch(E){throw t.removeEventListener("webglcontextlost",ze,!1),t.removeEventListener("webglcontextrestored",tt,!1),t.removeEventListener("webglcontextcreationerror",Pe,!1),Qe("WebGLRenderer: "+E.message),E}function et(){Je=new g1(F),Je.init(),_e=new KC(F,Je),lt=new r1(F,Je,e,_e),Ee=new jC(F,Je),lt.reversedDepthBuffer&&d&&Ee.buffers.depth.setReversed(!0),W=F.createFramebuffer(),U=F.createFramebuffer(),G=F.createFramebuffer(),zt=new x1(F),He=new OC,Ye=new JC(F,Je,Ee,He,lt,_e,zt),R=new m1(N),S=new bE(F),Se=new i1(F,S),$=new _1(F,S,zt,Se),he=new b1(F,$,S,Se,zt),se=new v1(F,lt,Ye),ne=new o1(He),re=new UC(N,R,Je,lt,Se,ne),ye=new nR(N,He),ve=new kC,ee=new WC(Je),O=new n1(N,R,Ee,he,p,l),pe=new ZC(N,he,lt),$e=new iR(F,zt,lt,Ee),te=new s1(F,Je,zt),Te=new y1(F,Je,zt),zt.programs=re.programs,N.capabilities=lt,N.extensions=Je,N.properties=He,N.renderLists=ve,N.shadowMap=pe,N.state=Ee,N.info=zt}_!==ei&&(k=new M1(_,t.width,t.height,a,s,r));let le=new Zp(N,F);this.xr=le,this.getContext=function(){return F},this.getContextAttributes=function(){return F.getContextAttributes()},this.forceContextLoss=function(){let E=Je.get("WEBGL_lose_context");E&&E.loseContext()},this.forceContextRestore=function(){let E=Je.get("WEBGL_lose_context");E&&E.restoreContext()},this.getPixelRatio=function(){return we},this.setPixelRatio=function(E){E!==void 0&&(we=E,this.setSize(xe,Re,!1))},this.getSize=function(E){return E.set(xe,Re)},this.setSize=function(E,B,J=!0){if(le.isPresenting){Ze("WebGLRenderer: Can't change size while VR device is presenting.");return}xe=E,Re=B,t.width=Math.floor(E*we),t.height=Math.floor(B*we),J===!0&&(t.style.width=E+"px",t.style.height=B+"px"),k!==null&&k.setSize(t.width,t.height),this.setViewport(0,0,E,B)},this.getDrawingBufferSize=function(E){return E.set(xe*we,Re*we).floor()},this.setDrawingBufferSize=function(E,B,J){xe=E,Re=B,we=J,t.width=Math.floor(E*J),t.height=Math.floor(B*J),this.setViewport(0,0,E,B)},this.setEffects=function(E){if(_===ei){Qe("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(E){for(let B=0;B<E.length;B++)if(E[B].isOutputPass===!0){Ze("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}k.setEffects(E||[])},this.getCurrentViewport=function(E){return E.copy(ie)},this.getViewport=function(E){return E.copy(We)},this.setViewport=function(E,B,J,q){E.isVector4?We.set(E.x,E.y,E.z,E.w):We.set(E,B,J,q),Ee.viewport(ie.copy(We).multiplyScalar(hn()).round())},this.getScissor=function(E){return E.copy(mt)},this.setScissor=function(E,B,J,q){E.isVector4?mt.set(E.x,E.y,E.z,E.w):mt.set(E,B,J,q),Ee.scissor(de.copy(mt).multiplyScalar(hn()).round())},this.getScissorTest=function(){return dt},this.setScissorTest=function(E){Ee.setScissorTest(dt=E)},this.setOpaqueSort=function(E){qe=E},this.setTransparentSort=function(E){at=E},this.getClearColor=function(E){return E.copy(O.getClearColor())},this.setClearColor=function(){O.setClearColor(...arguments)},this.getClearAlpha=function(){return O.getClearAlpha()},this.setClearAlpha=function(){O.setClearAlpha(...arguments)},this.clear=function(E=!0,B=!0,J=!0){let q=0;if(E){let X=!1;if(ce!==null){let Ae=ce.texture.format;X=m.has(Ae)}if(X){let Ae=ce.texture.type,Le=g.has(Ae),Ce=O.getClearColor(),De=O.getClearAlpha(),Ge=Ce.r,nt=Ce.g,gt=Ce.b;Le?(y[0]=Ge,y[1]=nt,y[2]=gt,y[3]=De,F.clearBufferuiv(F.COLOR,0,y)):(T[0]=Ge,T[1]=nt,T[2]=gt,T[3]=De,F.clearBufferiv(F.COLOR,0,T))}else q|=F.COLOR_BUFFER_BIT}B&&(q|=F.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),J&&(q|=F.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),q!==0&&F.clear(q)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(E){E.setRenderer(this),V=E},this.dispose=function(){t.removeEventListener("webglcontextlost",ze,!1),t.removeEventListener("webglcontextrestored",tt,!1),t.removeEventListener("webglcontextcreationerror",Pe,!1),O.dispose(),ve.dispose(),ee.dispose(),Ye.dispose(),He.dispose(),R.dispose(),he.dispose(),$.dispose(),Se.dispose(),$e.dispose(),re.dispose(),le.dispose(),le.removeEventListener("sessionstart",Il),le.removeEventListener("sessionend",qi),ds.stop()};function ze(E){E.preventDefault(),Wa("WebGLRenderer: Context Lost."),D=!0}function tt(){Wa("WebGLRenderer: Context Restored."),D=!1;let E=zt.autoReset,B=pe.enabled,J=pe.autoUpdate,q=pe.needsUpdate,X=pe.type;et(),zt.autoReset=E,pe.enabled=B,pe.autoUpdate=J,pe.needsUpdate=q,pe.type=X}function Pe(E){Qe("WebGLRenderer: A WebGL context could not be created. Reason: ",E.statusMessage)}function ct(E){let B=E.target;B.removeEventListener("dispose",ct),Wt(B)}function Wt(E){Gn(E),He.remove(E)}function Gn(E){let B=He.get(E).programs;B!==void 0&&(B.forEach(function(J){re.releaseProgram(J)}),E.isShaderMaterial&&re.releaseShaderCache(E))}this.renderBufferDirect=function(E,B,J,q,X,Ae){B===null&&(B=yn);let Le=X.isMesh&&X.matrixWorld.determinantAffine()<0,Ce=ta(E,B,J,q,X);Ee.setMaterial(q,Le);let De=J.index,Ge=1;if(q.wireframe===!0){if(De=$.getWireframeAttribute(J),De===void 0)return;Ge=2}let nt=J.drawRange,gt=J.attributes.position,Ve=nt.start*Ge,_t=(nt.start+nt.count)*Ge;Ae!==null&&(Ve=Math.max(Ve,Ae.start*Ge),_t=Math.min(_t,(Ae.start+Ae.count)*Ge)),De!==null?(Ve=Math.max(Ve,0),_t=Math.min(_t,De.count)):gt!=null&&(Ve=Math.max(Ve,0),_t=Math.min(_t,gt.count));let Qt=_t-Ve;if(Qt<0||Qt===1/0)return;Se.setup(X,q,Ce,J,De);let Ut,Ot=te;if(De!==null&&(Ut=S.get(De),Ot=Te,Ot.setIndex(Ut)),X.isMesh)q.wireframe===!0?(Ee.setLineWidth(q.wireframeLinewidth*hn()),Ot.setMode(F.LINES)):Ot.setMode(F.TRIANGLES);else if(X.isLine){let xn=q.linewidth;xn===void 0&&(xn=1),Ee.setLineWidth(xn*hn()),X.isLineSegments?Ot.setMode(F.LINES):X.isLineLoop?Ot.setMode(F.LINE_LOOP):Ot.setMode(F.LINE_STRIP)}else X.isPoints?Ot.setMode(F.POINTS):X.isSprite&&Ot.setMode(F.TRIANGLES);if(X.isBatchedMesh)if(Je.get("WEBGL_multi_draw"))Ot.renderMultiDraw(X._multiDrawStarts,X._multiDrawCounts,X._multiDrawCount);else{let xn=X._multiDrawStarts,ke=X._multiDrawCounts,un=X._multiDrawCount,xt=De?S.get(De).bytesPerElement:1,ps=He.get(q).currentProgram.getUniforms();for(let dn=0;dn<un;dn++)ps.setValue(F,"_gl_DrawID",dn),Ot.render(xn[dn]/xt,ke[dn])}else if(X.isInstancedMesh)Ot.renderInstances(Ve,Qt,X.count);else if(J.isInstancedBufferGeometry){let xn=J._maxInstanceCount!==void 0?J._maxInstanceCount:1/0,ke=Math.min(J.instanceCount,xn);Ot.renderInstances(Ve,Qt,ke)}else Ot.render(Ve,Qt)};function Ko(E,B,J,q){V!==null&&E.isNodeMaterial&&V.setObject(q,E),Ht===!0&&ne.setState(E,J,!1),E.transparent===!0&&E.side===Ai&&E.forceSinglePass===!1?(E.side=Kn,E.needsUpdate=!0,Xi(E,B,q),E.side=cr,E.needsUpdate=!0,Xi(E,B,q),E.side=Ai):Xi(E,B,q)}this.compile=function(E,B,J=null){J===null&&(J=E),V!==null&&V.renderStart(E,B,J),A=ee.get(J),A.init(B),M.push(A),J.traverseVisible(function(X){X.isLight&&X.layers.test(B.layers)&&(A.pushLight(X),X.castShadow&&A.pushShadow(X))}),E!==J&&E.traverseVisible(function(X){X.isLight&&X.layers.test(B.layers)&&(A.pushLight(X),X.castShadow&&A.pushShadow(X))}),A.setupLights(),V!==null&&V.updateLights(A.state.lightsArray),cn=this.localClippingEnabled,Ht=ne.init(this.clippingPlanes,cn),Ht===!0&&ne.setGlobalState(this.clippingPlanes,B),V!==null&&pe.render(A.state.shadowsArray,J,B);let q=new Set;return E.traverse(function(X){if(!(X.isMesh||X.isPoints||X.isLine||X.isSprite))return;let Ae=X.material;if(Ae)if(Array.isArray(Ae))for(let Le=0;Le<Ae.length;Le++){let Ce=Ae[Le];Ko(Ce,J,B,X),q.add(Ce)}else Ko(Ae,J,B,X),q.add(Ae)}),A=M.pop(),V!==null&&V.renderEnd(),q},this.compileAsync=function(E,B,J=null){let q=this.compile(E,B,J);return new Promise(X=>{function Ae(){if(q.forEach(function(Le){let De=He.get(Le).currentProgram;(De===void 0||De.isReady())&&q.delete(Le)}),q.size===0){X(E);return}setTimeout(Ae,10)}Je.get("KHR_parallel_shader_compile")!==null?Ae():setTimeout(Ae,10)})};let Vr=null;function sd(E){Vr&&Vr(E)}function Il(){ds.stop()}function qi(){ds.start()}let ds=new Dx;ds.setAnimationLoop(sd),typeof self<"u"&&ds.setContext(self),this.setAnimationLoop=function(E){Vr=E,le.setAnimationLoop(E),E===null?ds.stop():ds.start()},le.addEventListener("sessionstart",Il),le.addEventListener("sessionend",qi),this.render=function(E,B){if(B!==void 0&&B.isCamera!==!0){Qe("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(D===!0)return;V!==null&&V.renderStart(E,B);let J=le.enabled===!0&&le.isPresenting===!0,q=k!==null&&(ce===null||J)&&k.begin(N,ce);if(E.matrixWorldAutoUpdate===!0&&E.updateMatrixWorld(),B.parent===null&&B.matrixWorldAutoUpdate===!0&&B.updateMatrixWorld(),le.enabled===!0&&le.isPresenting===!0&&(k===null||k.isCompositing()===!1)&&(le.cameraAutoUpdate===!0&&le.updateCamera(B),B=le.getCamera()),E.isScene===!0&&E.onBeforeRender(N,E,B,ce),A=ee.get(E,M.length),A.init(B),A.state.textureUnits=Ye.getTextureUnits(),M.push(A),kt.multiplyMatrices(B.projectionMatrix,B.matrixWorldInverse),B.isArrayCamera?jt.setFromArrayCamera(B):rt.setFromProjectionMatrix(kt,wi,B.reversedDepth),cn=this.localClippingEnabled,Ht=ne.init(this.clippingPlanes,cn),C=ve.get(E,x.length),C.init(),x.push(C),this.info.render.frame++,le.enabled===!0&&le.isPresenting===!0){let Le=N.xr.getDepthSensingMesh();Le!==null&&fs(Le,B,-1/0,N.sortObjects)}fs(E,B,0,N.sortObjects),C.finish(),V!==null&&V.updateLights(A.state.lightsArray),N.sortObjects===!0&&C.sort(qe,at),en=le.enabled===!1||le.isPresenting===!1||le.hasDepthSensing()===!1,en&&O.addToRenderList(C,E),this.info.autoReset===!0&&this.info.reset(),Ht===!0&&ne.beginShadows();let X=A.state.shadowsArray;if(pe.render(X,E,B),Ht===!0&&ne.endShadows(),(q&&k.hasRenderPass())===!1){let Le=C.opaque,Ce=C.transmissive;if(A.setupLights(),B.isArrayCamera){let De=B.cameras;if(Ce.length>0)for(let Ge=0,nt=De.length;Ge<nt;Ge++){let gt=De[Ge];Ri(Le,Ce,E,gt)}en&&O.render(E);for(let Ge=0,nt=De.length;Ge<nt;Ge++){let gt=De[Ge];Qo(C,E,gt,gt.viewport)}}else Ce.length>0&&Ri(Le,Ce,E,B),en&&O.render(E),Qo(C,E,B)}ce!==null&&z===0&&(Ye.updateMultisampleRenderTarget(ce),Ye.updateRenderTargetMipmap(ce)),q&&k.end(N),E.isScene===!0&&E.onAfterRender(N,E,B),Se.resetDefaultState(),j=-1,K=null,M.pop(),M.length>0?(A=M[M.length-1],Ye.setTextureUnits(A.state.textureUnits),Ht===!0&&ne.setGlobalState(N.clippingPlanes,A.state.camera)):A=null,x.pop(),x.length>0?C=x[x.length-1]:C=null,V!==null&&V.renderEnd()};function fs(E,B,J,q){if(E.visible===!1)return;if(E.layers.test(B.layers)){if(E.isGroup)J=E.renderOrder;else if(E.isLOD)E.autoUpdate===!0&&E.update(B);else if(E.isLight)A.pushLight(E),E.castShadow&&A.pushShadow(E);else if(E.isSprite){let Le=B.isArrayCamera?jt:rt;if(!E.frustumCulled||E.intersectsFrustum(Le)){q&&wt.setFromMatrixPosition(E.matrixWorld).applyMatrix4(kt);let Ce=he.update(E),De=E.material;De.visible&&C.push(E,Ce,De,J,wt.z,null,B)}}else if(E.isMesh||E.isLine||E.isPoints){let Le=B.isArrayCamera?jt:rt;if(!E.frustumCulled||E.intersectsFrustum(Le)){let Ce=he.update(E),De=E.material;if(q&&(E.boundingSphere!==void 0?(E.boundingSphere===null&&E.computeBoundingSphere(),wt.copy(E.boundingSphere.center)):(Ce.boundingSphere===null&&Ce.computeBoundingSphere(),wt.copy(Ce.boundingSphere.center)),wt.applyMatrix4(E.matrixWorld).applyMatrix4(kt)),Array.isArray(De)){let Ge=Ce.groups;for(let nt=0,gt=Ge.length;nt<gt;nt++){let Ve=Ge[nt],_t=De[Ve.materialIndex];_t&&_t.visible&&C.push(E,Ce,_t,J,wt.z,Ve,B)}}else De.visible&&C.push(E,Ce,De,J,wt.z,null,B)}}}let Ae=E.children;for(let Le=0,Ce=Ae.length;Le<Ce;Le++)fs(Ae[Le],B,J,q)}function Qo(E,B,J,q){let{opaque:X,transmissive:Ae,transparent:Le}=E;A.setupLightsView(J),Ht===!0&&ne.setGlobalState(N.clippingPlanes,J),q&&Ee.viewport(ie.copy(q)),X.length>0&&tn(X,B,J),Ae.length>0&&tn(Ae,B,J),Le.length>0&&tn(Le,B,J),Ee.buffers.depth.setTest(!0),Ee.buffers.depth.setMask(!0),Ee.buffers.color.setMask(!0),Ee.setPolygonOffset(!1)}function Ri(E,B,J,q){if((J.isScene===!0?J.overrideMaterial:null)!==null)return;if(A.state.transmissionRenderTarget[q.id]===void 0){let Ve=Je.has("EXT_color_buffer_half_float")||Je.has("EXT_color_buffer_float");A.state.transmissionRenderTarget[q.id]=new mi(1,1,{generateMipmaps:!0,type:Ve?Wi:ei,minFilter:Ls,samples:Math.max(4,lt.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:bt.workingColorSpace})}let Ae=A.state.transmissionRenderTarget[q.id],Le=q.viewport||ie;Ae.setSize(Le.z*N.transmissionResolutionScale,Le.w*N.transmissionResolutionScale);let Ce=N.getRenderTarget(),De=N.getActiveCubeFace(),Ge=N.getActiveMipmapLevel();N.setRenderTarget(Ae),N.getClearColor(Q),ge=N.getClearAlpha(),ge<1&&N.setClearColor(16777215,.5),N.clear(),en&&O.render(J);let nt=N.toneMapping;N.toneMapping=cs;let gt=q.viewport;if(q.viewport!==void 0&&(q.viewport=void 0),A.setupLightsView(q),Ht===!0&&ne.setGlobalState(N.clippingPlanes,q),tn(E,J,q),Ye.updateMultisampleRenderTarget(Ae),Ye.updateRenderTargetMipmap(Ae),Je.has("WEBGL_multisampled_render_to_texture")===!1){let Ve=!1;for(let _t=0,Qt=B.length;_t<Qt;_t++){let Ut=B[_t],{object:Ot,geometry:xn,material:ke,group:un}=Ut;if(ke.side===Ai&&Ot.layers.test(q.layers)){let xt=ke.side;ke.side=Kn,ke.needsUpdate=!0,on(Ot,J,q,xn,ke,un),ke.side=xt,ke.needsUpdate=!0,Ve=!0}}Ve===!0&&(Ye.updateMultisampleRenderTarget(Ae),Ye.updateRenderTargetMipmap(Ae))}N.setRenderTarget(Ce,De,Ge),N.setClearColor(Q,ge),gt!==void 0&&(q.viewport=gt),N.toneMapping=nt}function tn(E,B,J){let q=B.isScene===!0?B.overrideMaterial:null;for(let X=0,Ae=E.length;X<Ae;X++){let Le=E[X],{object:Ce,geometry:De,group:Ge}=Le,nt=Le.material;nt.allowOverride===!0&&q!==null&&(nt=q),Ce.layers.test(J.layers)&&on(Ce,B,J,De,nt,Ge)}}function on(E,B,J,q,X,Ae){V!==null&&X.isNodeMaterial&&V.setObject(E,X),E.onBeforeRender(N,B,J,q,X,Ae),E.modelViewMatrix.multiplyMatrices(J.matrixWorldInverse,E.matrixWorld),E.normalMatrix.getNormalMatrix(E.modelViewMatrix),X.onBeforeRender(N,B,J,q,E,Ae),X.transparent===!0&&X.side===Ai&&X.forceSinglePass===!1?(X.side=Kn,X.needsUpdate=!0,N.renderBufferDirect(J,B,q,X,E,Ae),X.side=cr,X.needsUpdate=!0,N.renderBufferDirect(J,B,q,X,E,Ae),X.side=Ai):N.renderBufferDirect(J,B,q,X,E,Ae),E.onAfterRender(N,B,J,q,X,Ae)}function an(E){let B=0;for(let J of E)J.texture!==null&&B++;return B}function Xi(E,B,J){B.isScene!==!0&&(B=yn);let q=He.get(E),X=A.state.lights,Ae=A.state.shadowsArray,Le=X.state.version,Ce=re.getParameters(E,X.state,Ae,B,J,A.state.lightProbeGridArray),De=re.getProgramCacheKey(Ce),Ge=q.programs;q.environment=E.isMeshStandardMaterial||E.isMeshLambertMaterial||E.isMeshPhongMaterial?B.environment:null,q.fog=B.fog;let nt=E.isMeshStandardMaterial||E.isMeshLambertMaterial&&!E.envMap||E.isMeshPhongMaterial&&!E.envMap;q.envMap=R.get(E.envMap||q.environment,nt),q.envMapRotation=q.environment!==null&&E.envMap===null?B.environmentRotation:E.envMapRotation,Ge===void 0&&(E.addEventListener("dispose",ct),Ge=new Map,q.programs=Ge,q.programVariants=new Map);let gt=Ge.get(De);if(gt!==void 0){if(q.currentProgram===gt&&q.lightsStateVersion===Le)return ea(E,Ce),gt}else Ce.uniforms=re.getUniforms(E),V!==null&&E.isNodeMaterial&&V.build(E,J,Ce),E.onBeforeCompile(Ce,N),gt=re.acquireProgram(Ce,De),Ge.set(De,gt),q.uniforms=Ce.uniforms;let Ve=q.uniforms;return(!E.isShaderMaterial&&!E.isRawShaderMaterial||E.clipping===!0)&&(Ve.clippingPlanes=ne.uniform),ea(E,Ce),q.needsLights=ks(E),q.lightsStateVersion=Le,q.needsLights&&(Ve.ambientLightColor.value=X.state.ambient,Ve.lightProbe.value=X.state.probe,Ve.sunLights.value=X.state.sun,Ve.sunLightShadows.value=X.state.sunShadow,Ve.directionalLights.value=X.state.directional,Ve.directionalLightShadows.value=X.state.directionalShadow,Ve.spotLights.value=X.state.spot,Ve.spotLightShadows.value=X.state.spotShadow,Ve.rectAreaLights.value=X.state.rectArea,Ve.ltc_1.value=X.state.rectAreaLTC1,Ve.ltc_2.value=X.state.rectAreaLTC2,Ve.pointLights.value=X.state.point,Ve.pointLightShadows.value=X.state.pointShadow,Ve.hemisphereLights.value=X.state.hemi,Ve.sunShadowMatrix.value=X.state.sunShadowMatrix,Ve.sunShadowCascade.value=X.state.sunShadowCascade,Ve.directionalShadowMatrix.value=X.state.directionalShadowMatrix,Ve.spotLightMatrix.value=X.state.spotLightMatrix,Ve.spotLightMap.value=X.state.spotLightMap,Ve.pointShadowMatrix.value=X.state.pointShadowMatrix),q.numLightProbeGrids=an(A.state.lightProbeGridArray),q.currentProgram=gt,q.uniformsList=null,gt}function ni(E,B,J,q,X){let Ae=He.get(E),Le=Ae.currentProgram.id+","+q+","+X,Ce=Ae.programVariants.get(Le);return Ce===void 0?(Ce=Xi(E,B,J),Ae.programVariants.set(Le,Ce)):(Ae.currentProgram=Ce,Ae.uniformsList=null,Ae.outputColorSpace=q,Ae.toneMapping=X),Ce}function Fs(E){if(E.uniformsList===null){let B=E.currentProgram.getUniforms();E.uniformsList=Zo.seqWithValue(B.seq,E.uniforms)}return E.uniformsList}function ea(E,B){let J=He.get(E);J.outputColorSpace=B.outputColorSpace,J.batching=B.batching,J.batchingColor=B.batchingColor,J.instancing=B.instancing,J.instancingColor=B.instancingColor,J.instancingMorph=B.instancingMorph,J.skinning=B.skinning,J.morphTargets=B.morphTargets,J.morphNormals=B.morphNormals,J.morphColors=B.morphColors,J.morphTargetsCount=B.morphTargetsCount,J.numClippingPlanes=B.numClippingPlanes,J.numIntersection=B.numClipIntersection,J.vertexAlphas=B.vertexAlphas,J.vertexTangents=B.vertexTangents,J.toneMapping=B.toneMapping}function ta(E,B,J,q,X){B.isScene!==!0&&(B=yn),Ye.resetTextureUnits();let Ae=B.fog,Le=q.isMeshStandardMaterial||q.isMeshLambertMaterial||q.isMeshPhongMaterial?B.environment:null,Ce=ce===null?N.outputColorSpace:ce.isXRRenderTarget===!0?ce.texture.colorSpace:bt.workingColorSpace,De=q.isMeshStandardMaterial||q.isMeshLambertMaterial&&!q.envMap||q.isMeshPhongMaterial&&!q.envMap,Ge=R.get(q.envMap||Le,De),nt=q.vertexColors===!0&&!!J.attributes.color&&J.attributes.color.itemSize===4,gt=!!J.attributes.tangent&&(!!q.normalMap||q.anisotropy>0),Ve=!!J.morphAttributes.position,_t=!!J.morphAttributes.normal,Qt=!!J.morphAttributes.color,Ut=cs;q.toneMapped&&(ce===null||ce.isXRRenderTarget===!0)&&(Ut=N.toneMapping);let Ot=J.morphAttributes.position||J.morphAttributes.normal||J.morphAttributes.color,xn=Ot!==void 0?Ot.length:0,ke=He.get(q),un=A.state.lights;if(Ht===!0&&(cn===!0||E!==K)){let Ft=E===K&&q.id===j;ne.setState(q,E,Ft)}let xt=!1,ps=!1;q.version===ke.__version?ke.needsLights&&ke.lightsStateVersion!==un.state.version||X.isBatchedMesh&&ke.batching===!1||!X.isBatchedMesh&&ke.batching===!0||X.isBatchedMesh&&ke.batchingColor===!0&&X._colorsTexture===null||X.isBatchedMesh&&ke.batchingColor===!1&&X._colorsTexture!==null||X.isInstancedMesh&&ke.instancing===!1||!X.isInstancedMesh&&ke.instancing===!0||X.isSkinnedMesh&&ke.skinning===!1||!X.isSkinnedMesh&&ke.skinning===!0||X.isInstancedMesh&&ke.instancingColor===!0&&X.instanceColor===null||X.isInstancedMesh&&ke.instancingColor===!1&&X.instanceColor!==null||X.isInstancedMesh&&ke.instancingMorph===!0&&X.morphTexture===null||X.isInstancedMesh&&ke.instancingMorph===!1&&X.morphTexture!==null||ke.envMap!==Ge||q.fog===!0&&ke.fog!==Ae||ke.numClippingPlanes!==void 0&&(ke.numClippingPlanes!==ne.numPlanes||ke.numIntersection!==ne.numIntersection)||ke.vertexAlphas!==nt||ke.vertexTangents!==gt||ke.morphTargets!==Ve||ke.morphNormals!==_t||ke.morphColors!==Qt||ke.morphTargetsCount!==xn||ke.numLightProbeGrids!==an(A.state.lightProbeGridArray)?xt=!0:(ke.outputColorSpace!==Ce||ke.toneMapping!==Ut)&&(ps=!0):(xt=!0,ke.__version=q.version);let dn=ke.currentProgram;(xt===!0||ps===!0)&&(dn=ps===!0?ni(q,B,X,Ce,Ut):Xi(q,B,X),V&&q.isNodeMaterial&&V.onUpdateProgram(q,dn,ke));let Wr=!1,Yi=!1,ms=!1,ft=dn.getUniforms(),nn=ke.uniforms;if(Ee.useProgram(dn.program)&&(Wr=!0,Yi=!0,ms=!0),q.id!==j&&(j=q.id,Yi=!0),Wr||K!==E){Ee.buffers.depth.getReversed()&&E.reversedDepth!==!0&&(E._reversedDepth=!0,E.updateProjectionMatrix()),ft.setValue(F,"projectionMatrix",E.projectionMatrix),ft.setValue(F,"viewMatrix",E.matrixWorldInverse);let fn=ft.map.cameraPosition;fn!==void 0&&fn.setValue(F,Cn.setFromMatrixPosition(E.matrixWorld)),lt.logarithmicDepthBuffer&&ft.setValue(F,"logDepthBufFC",2/(Math.log(E.far+1)/Math.LN2)),(q.isMeshPhongMaterial||q.isMeshToonMaterial||q.isMeshLambertMaterial||q.isMeshBasicMaterial||q.isMeshStandardMaterial||q.isShaderMaterial)&&ft.setValue(F,"isOrthographic",E.isOrthographicCamera===!0),K!==E&&(K=E,Yi=!0,ms=!0)}if(ke.needsLights&&(un.state.sunShadowMap.length>0&&ft.setValue(F,"sunShadowMap",un.state.sunShadowMap,Ye),un.state.directionalShadowMap.length>0&&ft.setValue(F,"directionalShadowMap",un.state.directionalShadowMap,Ye),un.state.spotShadowMap.length>0&&ft.setValue(F,"spotShadowMap",un.state.spotShadowMap,Ye),un.state.pointShadowMap.length>0&&ft.setValue(F,"pointShadowMap",un.state.pointShadowMap,Ye)),X.isSkinnedMesh){ft.setOptional(F,X,"bindMatrix"),ft.setOptional(F,X,"bindMatrixInverse");let Ft=X.skeleton;Ft&&(Ft.boneTexture===null&&Ft.computeBoneTexture(),ft.setValue(F,"boneTexture",Ft.boneTexture,Ye))}X.isBatchedMesh&&(ft.setOptional(F,X,"batchingTexture"),ft.setValue(F,"batchingTexture",X._matricesTexture,Ye),ft.setOptional(F,X,"batchingIdTexture"),ft.setValue(F,"batchingIdTexture",X._indirectTexture,Ye),ft.setOptional(F,X,"batchingColorTexture"),X._colorsTexture!==null&&ft.setValue(F,"batchingColorTexture",X._colorsTexture,Ye));let Hn=J.morphAttributes;if((Hn.position!==void 0||Hn.normal!==void 0||Hn.color!==void 0)&&se.update(X,J,dn),(Yi||ke.receiveShadow!==X.receiveShadow)&&(ke.receiveShadow=X.receiveShadow,ft.setValue(F,"receiveShadow",X.receiveShadow)),(q.isMeshStandardMaterial||q.isMeshLambertMaterial||q.isMeshPhongMaterial)&&q.envMap===null&&B.environment!==null&&(nn.envMapIntensity.value=B.environmentIntensity),nn.dfgLUT!==void 0&&(nn.dfgLUT.value=rR()),Yi){if(ft.setValue(F,"toneMappingExposure",N.toneMappingExposure),ke.needsLights&&Gr(nn,ms),Ae&&q.fog===!0&&ye.refreshFogUniforms(nn,Ae),ye.refreshMaterialUniforms(nn,q,we,Re,A.state.transmissionRenderTarget[E.id]),ke.needsLights&&ke.numLightProbeGrids>0){let Ft=b,fn=0;for(let Fn of A.state.lightProbeGridArray)Fn.texture!==null&&(Ft.textures[fn]=Fn.texture,Ft.min[fn]=Fn.boundingBox.min,Ft.max[fn]=Fn.boundingBox.max,Ft.resolution[fn]=Fn.resolution,fn++);for(let Fn in Ft)Ft[Fn].length=fn;nn.probesSH.value=Ft.textures,nn.probesMin.value=Ft.min,nn.probesMax.value=Ft.max,nn.probesResolution.value=Ft.resolution}Zo.upload(F,Fs(ke),nn,Ye)}if(q.isShaderMaterial&&q.uniformsNeedUpdate===!0&&(Zo.upload(F,Fs(ke),nn,Ye),q.uniformsNeedUpdate=!1),q.isSpriteMaterial&&ft.setValue(F,"center",X.center),ft.setValue(F,"modelViewMatrix",X.modelViewMatrix),ft.setValue(F,"normalMatrix",X.normalMatrix),ft.setValue(F,"modelMatrix",X.matrixWorld),q.uniformsGroups!==void 0){let Ft=q.uniformsGroups;for(let fn=0,Fn=Ft.length;fn<Fn;fn++){let Ll=Ft[fn];$e.update(Ll,dn),$e.bind(Ll,dn)}}return dn}function Gr(E,B){E.ambientLightColor.needsUpdate=B,E.lightProbe.needsUpdate=B,E.sunLights.needsUpdate=B,E.sunLightShadows.needsUpdate=B,E.directionalLights.needsUpdate=B,E.directionalLightShadows.needsUpdate=B,E.pointLights.needsUpdate=B,E.pointLightShadows.needsUpdate=B,E.spotLights.needsUpdate=B,E.spotLightShadows.needsUpdate=B,E.rectAreaLights.needsUpdate=B,E.hemisphereLights.needsUpdate=B}function ks(E){return E.isMeshLambertMaterial||E.isMeshToonMaterial||E.isMeshPhongMaterial||E.isMeshStandardMaterial||E.isShadowMaterial||E.isShaderMaterial&&E.lights===!0}this.getActiveCubeFace=function(){return Z},this.getActiveMipmapLevel=function(){return z},this.getRenderTarget=function(){return ce},this.setRenderTargetTextures=function(E,B,J){let q=He.get(E);q.__autoAllocateDepthBuffer=E.resolveDepthBuffer===!1,q.__autoAllocateDepthBuffer===!1&&(q.__useRenderToTexture=!1),He.get(E.texture).__webglTexture=B,He.get(E.depthTexture).__webglTexture=q.__autoAllocateDepthBuffer?void 0:J,q.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(E,B){let J=He.get(E);J.__webglFramebuffer=B,J.__useDefaultFramebuffer=B===void 0},this.setRenderTarget=function(E,B=0,J=0){ce=E,Z=B,z=J;let q=null,X=!1,Ae=!1;if(E){let Ce=He.get(E);if(Ce.__useDefaultFramebuffer!==void 0){Ee.bindFramebuffer(F.FRAMEBUFFER,Ce.__webglFramebuffer),ie.copy(E.viewport),de.copy(E.scissor),ue=E.scissorTest,Ee.viewport(ie),Ee.scissor(de),Ee.setScissorTest(ue),j=-1;return}else if(Ce.__webglFramebuffer===void 0)Ye.setupRenderTarget(E);else if(Ce.__hasExternalTextures)Ye.rebindTextures(E,He.get(E.texture).__webglTexture,He.get(E.depthTexture).__webglTexture);else if(E.depthBuffer){let nt=E.depthTexture;if(Ce.__boundDepthTexture!==nt){if(nt!==null&&He.has(nt)&&(E.width!==nt.image.width||E.height!==nt.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Ye.setupDepthRenderbuffer(E)}}let De=E.texture;(De.isData3DTexture||De.isDataArrayTexture||De.isCompressedArrayTexture)&&(Ae=!0);let Ge=He.get(E).__webglFramebuffer;E.isWebGLCubeRenderTarget?(Array.isArray(Ge[B])?q=Ge[B][J]:q=Ge[B],X=!0):E.samples>0&&Ye.useMultisampledRTT(E)===!1?q=He.get(E).__webglMultisampledFramebuffer:Array.isArray(Ge)?q=Ge[J]:q=Ge,ie.copy(E.viewport),de.copy(E.scissor),ue=E.scissorTest}else ie.copy(We).multiplyScalar(we).floor(),de.copy(mt).multiplyScalar(we).floor(),ue=dt;if(J!==0&&(q=W),Ee.bindFramebuffer(F.FRAMEBUFFER,q)&&Ee.drawBuffers(E,q),Ee.viewport(ie),Ee.scissor(de),Ee.setScissorTest(ue),X){let Ce=He.get(E.texture);F.framebufferTexture2D(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_CUBE_MAP_POSITIVE_X+B,Ce.__webglTexture,J)}else if(Ae){let Ce=B;for(let De=0;De<E.textures.length;De++){let Ge=He.get(E.textures[De]);F.framebufferTextureLayer(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0+De,Ge.__webglTexture,J,Ce)}}else if(E!==null&&J!==0){let Ce=He.get(E.texture);F.framebufferTexture2D(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,Ce.__webglTexture,J)}j=-1};function Hr(E){let B=He.get(E);return(B.__readFormat!==E.format||B.__readType!==E.type)&&(B.__readFormat=E.format,B.__readType=E.type,B.__formatReadable=lt.textureFormatReadable(E.format),B.__typeReadable=lt.textureTypeReadable(E.type)),B}this.readRenderTargetPixels=function(E,B,J,q,X,Ae,Le,Ce=0){if(!(E&&E.isWebGLRenderTarget)){Qe("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let De=He.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&Le!==void 0&&(De=De[Le],Array.isArray(De)&&(De=De[0])),De){Ee.bindFramebuffer(F.FRAMEBUFFER,De);try{let Ge=E.textures[Ce],nt=Ge.format,gt=Ge.type;E.textures.length>1&&F.readBuffer(F.COLOR_ATTACHMENT0+Ce);let Ve=Hr(Ge);if(Ve.__formatReadable===!1){Qe("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Ve.__typeReadable===!1){Qe("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}B>=0&&B<=E.width-q&&J>=0&&J<=E.height-X&&F.readPixels(B,J,q,X,_e.convert(nt),_e.convert(gt),Ae)}finally{let Ge=ce!==null?He.get(ce).__webglFramebuffer:null;Ee.bindFramebuffer(F.FRAMEBUFFER,Ge)}}},this.readRenderTargetPixelsAsync=async function(E,B,J,q,X,Ae,Le,Ce=0){if(!(E&&E.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let De=He.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&Le!==void 0&&(De=De[Le],Array.isArray(De)&&(De=De[0])),De)if(B>=0&&B<=E.width-q&&J>=0&&J<=E.height-X){Ee.bindFramebuffer(F.FRAMEBUFFER,De);let Ge=E.textures[Ce],nt=Ge.format,gt=Ge.type;E.textures.length>1&&F.readBuffer(F.COLOR_ATTACHMENT0+Ce);let Ve=Hr(Ge);if(Ve.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Ve.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let _t=F.createBuffer();F.bindBuffer(F.PIXEL_PACK_BUFFER,_t),F.bufferData(F.PIXEL_PACK_BUFFER,Ae.byteLength,F.STREAM_READ),F.readPixels(B,J,q,X,_e.convert(nt),_e.convert(gt),0),F.bindBuffer(F.PIXEL_PACK_BUFFER,null);let Qt=ce!==null?He.get(ce).__webglFramebuffer:null;Ee.bindFramebuffer(F.FRAMEBUFFER,Qt);let Ut=F.fenceSync(F.SYNC_GPU_COMMANDS_COMPLETE,0);return F.flush(),await rx(F,Ut,4),F.bindBuffer(F.PIXEL_PACK_BUFFER,_t),F.getBufferSubData(F.PIXEL_PACK_BUFFER,0,Ae),F.bindBuffer(F.PIXEL_PACK_BUFFER,null),F.deleteBuffer(_t),F.deleteSync(Ut),Ae}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(E,B=null,J=0){let q=Math.pow(2,-J),X=Math.floor(E.image.width*q),Ae=Math.floor(E.image.height*q),Le=B!==null?B.x:0,Ce=B!==null?B.y:0;Ye.setTexture2D(E,0),F.copyTexSubImage2D(F.TEXTURE_2D,J,0,0,Le,Ce,X,Ae),Ee.unbindTexture()},this.copyTextureToTexture=function(E,B,J=null,q=null,X=0,Ae=0){let Le,Ce,De,Ge,nt,gt,Ve,_t,Qt,Ut=E.isCompressedTexture?E.mipmaps[Ae]:E.image;if(J!==null)Le=J.max.x-J.min.x,Ce=J.max.y-J.min.y,De=J.isBox3?J.max.z-J.min.z:1,Ge=J.min.x,nt=J.min.y,gt=J.isBox3?J.min.z:0;else{let ft=Math.pow(2,-X);Le=Math.floor(Ut.width*ft),Ce=Math.floor(Ut.height*ft),E.isDataArrayTexture?De=Ut.depth:E.isData3DTexture?De=Math.floor(Ut.depth*ft):De=1,Ge=0,nt=0,gt=0}q!==null?(Ve=q.x,_t=q.y,Qt=q.z):(Ve=0,_t=0,Qt=0);let Ot=_e.convert(B.format),xn=_e.convert(B.type),ke;B.isData3DTexture?(Ye.setTexture3D(B,0),ke=F.TEXTURE_3D):B.isDataArrayTexture||B.isCompressedArrayTexture?(Ye.setTexture2DArray(B,0),ke=F.TEXTURE_2D_ARRAY):(Ye.setTexture2D(B,0),ke=F.TEXTURE_2D),Ee.activeTexture(F.TEXTURE0),Ee.pixelStorei(F.UNPACK_FLIP_Y_WEBGL,B.flipY),Ee.pixelStorei(F.UNPACK_PREMULTIPLY_ALPHA_WEBGL,B.premultiplyAlpha),Ee.pixelStorei(F.UNPACK_ALIGNMENT,B.unpackAlignment);let un=Ee.getParameter(F.UNPACK_ROW_LENGTH),xt=Ee.getParameter(F.UNPACK_IMAGE_HEIGHT),ps=Ee.getParameter(F.UNPACK_SKIP_PIXELS),dn=Ee.getParameter(F.UNPACK_SKIP_ROWS),Wr=Ee.getParameter(F.UNPACK_SKIP_IMAGES);Ee.pixelStorei(F.UNPACK_ROW_LENGTH,Ut.width),Ee.pixelStorei(F.UNPACK_IMAGE_HEIGHT,Ut.height),Ee.pixelStorei(F.UNPACK_SKIP_PIXELS,Ge),Ee.pixelStorei(F.UNPACK_SKIP_ROWS,nt),Ee.pixelStorei(F.UNPACK_SKIP_IMAGES,gt);let Yi=E.isDataArrayTexture||E.isData3DTexture,ms=B.isDataArrayTexture||B.isData3DTexture;if(E.isDepthTexture){let ft=He.get(E),nn=He.get(B),Hn=He.get(ft.__renderTarget),Ft=He.get(nn.__renderTarget);Ee.bindFramebuffer(F.READ_FRAMEBUFFER,Hn.__webglFramebuffer),Ee.bindFramebuffer(F.DRAW_FRAMEBUFFER,Ft.__webglFramebuffer);for(let fn=0;fn<De;fn++)Yi&&(F.framebufferTextureLayer(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,He.get(E).__webglTexture,X,gt+fn),F.framebufferTextureLayer(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,He.get(B).__webglTexture,Ae,Qt+fn)),F.blitFramebuffer(Ge,nt,Ge+Le,nt+Ce,Ve,_t,Ve+Le,_t+Ce,F.DEPTH_BUFFER_BIT,F.NEAREST);Ee.bindFramebuffer(F.READ_FRAMEBUFFER,null),Ee.bindFramebuffer(F.DRAW_FRAMEBUFFER,null)}else if(X!==0||E.isRenderTargetTexture||He.has(E)){let ft=He.get(E),nn=He.get(B);Ee.bindFramebuffer(F.READ_FRAMEBUFFER,U),Ee.bindFramebuffer(F.DRAW_FRAMEBUFFER,G);for(let Hn=0;Hn<De;Hn++)Yi?F.framebufferTextureLayer(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,ft.__webglTexture,X,gt+Hn):F.framebufferTexture2D(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,ft.__webglTexture,X),ms?F.framebufferTextureLayer(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,nn.__webglTexture,Ae,Qt+Hn):F.framebufferTexture2D(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,nn.__webglTexture,Ae),X!==0?F.blitFramebuffer(Ge,nt,Ge+Le,nt+Ce,Ve,_t,Ve+Le,_t+Ce,F.COLOR_BUFFER_BIT,F.NEAREST):ms?F.copyTexSubImage3D(ke,Ae,Ve,_t,Qt+Hn,Ge,nt,Le,Ce):F.copyTexSubImage2D(ke,Ae,Ve,_t,Ge,nt,Le,Ce);Ee.bindFramebuffer(F.READ_FRAMEBUFFER,null),Ee.bindFramebuffer(F.DRAW_FRAMEBUFFER,null)}else ms?E.isDataTexture||E.isData3DTexture?F.texSubImage3D(ke,Ae,Ve,_t,Qt,Le,Ce,De,Ot,xn,Ut.data):B.isCompressedArrayTexture?F.compressedTexSubImage3D(ke,Ae,Ve,_t,Qt,Le,Ce,De,Ot,Ut.data):F.texSubImage3D(ke,Ae,Ve,_t,Qt,Le,Ce,De,Ot,xn,Ut):E.isDataTexture?F.texSubImage2D(F.TEXTURE_2D,Ae,Ve,_t,Le,Ce,Ot,xn,Ut.data):E.isCompressedTexture?F.compressedTexSubImage2D(F.TEXTURE_2D,Ae,Ve,_t,Ut.width,Ut.height,Ot,Ut.data):F.texSubImage2D(F.TEXTURE_2D,Ae,Ve,_t,Le,Ce,Ot,xn,Ut);Ee.pixelStorei(F.UNPACK_ROW_LENGTH,un),Ee.pixelStorei(F.UNPACK_IMAGE_HEIGHT,xt),Ee.pixelStorei(F.UNPACK_SKIP_PIXELS,ps),Ee.pixelStorei(F.UNPACK_SKIP_ROWS,dn),Ee.pixelStorei(F.UNPACK_SKIP_IMAGES,Wr),Ae===0&&B.generateMipmaps===!0&&B.mipmapsAutoUpdate===!0&&F.generateMipmap(ke),Ee.unbindTexture()},this.initRenderTarget=function(E){He.get(E).__webglFramebuffer===void 0&&Ye.setupRenderTarget(E)},this.initTexture=function(E){E.isCubeTexture?Ye.setTextureCube(E,0):E.isData3DTexture?Ye.setTexture3D(E,0):E.isDataArrayTexture||E.isCompressedArrayTexture?Ye.setTexture2DArray(E,0):Ye.setTexture2D(E,0),Ee.unbindTexture()},this.resetState=function(){Z=0,z=0,ce=null,Ee.reset(),Se.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return wi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=bt._getDrawingBufferColorSpace(e),t.unpackColorSpace=bt._getUnpackColorSpace()}};var zr=[12399,4410988,8092536,12101998,16705592],jp=13697084;function Wx(i,{top:e,limited:t}){let n=Math.abs(i)/e;if(t&&n>1)return new it(jp);let s=Math.min(n,1)*(zr.length-1),r=Math.min(Math.floor(s),zr.length-2);return new it(zr[r]).lerp(new it(zr[r+1]),s-r)}var Kp={none:"plain",limit:"share of its limit",utilisation:"load over the maker's range",deflection:"deflection at rest",compression:"compression at rest",energy:"strain energy of the mode"};function Xx(i,{verdict:e,check:t,modes:n},s,r){let o=Kp[i];switch(i){case"none":return null;case"limit":{let a=e?.cases.find(l=>l.case===s);return $x(a?.decides===!1?`${o}, not binding in this case`:o,(a?.elements??[]).map(l=>[l.element,l.share??1/0]))}case"utilisation":return $x(o,Jp(t,s).flatMap(a=>a.utilisation===null?[]:[[a.element,a.utilisation]]));case"deflection":return qx(o,"m",Jp(t,s).map(a=>[a.element,a.deflection]));case"compression":return qx(o,"N",Jp(t,s).map(a=>[a.element,a.compression]));case"energy":{let l=n?.modes.find(c=>c.number===r)?.strain_energy_share?.map((c,h)=>[n.elements[h],c])??[];return l.length?{title:o,values:new Map(l),words:Zx,top:Math.max(...l.map(c=>Math.abs(c[1])),1e-12),limited:!1}:null}}}function Yx(i){switch(i){case"none":return"";case"limit":return"No load, force or deflection of a mount has a limit in this file.";case"utilisation":return"No mount of this file has a load range of its maker.";case"energy":return"No mode is shown, or it strains no element.";case"deflection":return"No mount deflects at rest: nothing loads it, or a preload bears the load.";case"compression":return"Nothing loads the mounts at rest: the file has no gravity."}}function Jp(i,e){let t=i?.mounts??[],n=t.filter(s=>s.case===e);return n.length?n:t.filter(s=>s.case==="")}var Zx=i=>Number.isFinite(i)?`${je(100*i,3)} %`:"∞",$x=(i,e)=>e.length?{title:i,values:new Map(e),words:Zx,top:1,limited:!0}:null;function qx(i,e,t){let n=Math.max(0,...t.map(r=>Math.abs(r[1]))),s=Hl(n,e);return n>0?{title:i,values:new Map(t),words:r=>`${je(r*s.factor,3)} ${s.unit}`,top:n,limited:!1}:null}var jx=i=>`#${i.toString(16).padStart(6,"0")}`;function Jx(i,e,t,n){if(i==="none")return Ue;if(!e)return ae`<div class="legend">${n||Yx(i)}</div>`;let{title:s,values:r,words:o,top:a,limited:l}=e,c=[...r].reduce((h,u)=>Math.abs(u[1])>Math.abs(h[1])?u:h);return ae`<div class="legend" role="img" aria-label="Colours of mounts: ${s}, from 0 to ${o(a)}; largest: ${c[0]}, ${o(c[1])}">
    <b>${s}${t?ae` <span class="old">…</span>`:Ue}</b>
    <svg viewBox="0 0 150 10" aria-hidden="true">
      <defs><linearGradient id="mount-colours">${zr.map((h,u)=>eo`<stop offset=${u/(zr.length-1)} stop-color=${jx(h)}></stop>`)}</linearGradient></defs>
      <rect width=${l?128:150} height="10" fill="url(#mount-colours)"></rect>
      ${l?eo`<rect x="134" width="16" height="10" fill=${jx(jp)}></rect>`:Ue}
    </svg>
    <span class=${l?"ticks limited":"ticks"}><span>0</span><span>${o(a)}</span>${l?ae`<span>over</span>`:Ue}</span>
    <span>most: ${c[0]}, ${o(c[1])}</span></div>`}function Qp(i,e){let t=document.createElement("a");t.href=URL.createObjectURL(e),t.download=i,t.click(),URL.revokeObjectURL(t.href)}var $u={background:16054008,body:10335432,edge:3690591,mount:3885652,metal:9147804,selected:14711552,force:12859677,rest:6124675,grid:13884128,trace:26012,text:"#24323b"},qu={background:1317149,body:6258070,edge:12177375,mount:10135472,metal:6976893,selected:16757575,force:16747110,rest:9414067,grid:2831419,trace:8177650,text:"#dbe5ec"};function oR(i,e){return[0,3].flatMap(t=>[0,1,2].map(n=>[0,1].map(s=>e.reduce((r,o,a)=>r+o[n]*i[t+a][s],0))))}var em=i=>[{order:1,amplitudes:i}];function Us(i,e,t){let[n,s,r,o,a,l]=tm(i,t);return[n+a*e[2]-l*e[1],s+l*e[0]-o*e[2],r+o*e[1]-a*e[0]]}function tm(i,e){let t=[0,0,0,0,0,0];for(let{order:n,amplitudes:s}of i){let r=Math.cos(n*e),o=Math.sin(n*e);s.forEach(([a,l],c)=>{t[c]+=a*r-l*o})}return t}function Qx(i,e){let t=new Map;for(let{name:n,axes:s,dofs:r}of i){let o=r.map(a=>e[a]);o.every(a=>a!==void 0)&&t.set(n,em(oR(o,s)))}return t}var ev=(i,e)=>new Map(i?.map((t,n)=>[t,em(e[n])])),Kx=i=>i.map(e=>[e,0]);function tv(i,e,t){let n=i.modes[e];return n?.shape?{label:`Mode ${n.number}`,words:n.name,angular_frequency:n.angular_frequency,ends:ev(i.feet,n.feet?.map(Kx)),bodies:Qx(t,Kx(n.shape))}:null}function nv(i,e,t){let n=i.roots.find(s=>s.nearest_mode===e&&s.eigenvalue[1]>0);return n?{label:`Damped mode ${e}`,words:"",angular_frequency:n.eigenvalue[1],ends:ev(i.feet,n.feet),bodies:Qx(t,n.shape)}:null}function iv(i,e){let t=i.shapes[0];return t?{label:"Operating shape",words:"",angular_frequency:t.angular_frequency,hasSize:!0,...rv(t.places.map(({name:n,motion:s})=>[n,em(s)]),e)}:null}function sv(i,e,t,n){let s=i.places.map(({name:r,harmonics:o})=>[r,o.map((a,l)=>({order:l,amplitudes:a}))]);return{label:"Steady motion",words:t,angular_frequency:e,hasSize:!0,...rv(s,n)}}function rv(i,e){let t=([n])=>e.some(s=>s.name===n);return{bodies:new Map(i.filter(t)),ends:new Map(i.filter(n=>!t(n)&&aR(n[1])))}}var aR=i=>i.some(({amplitudes:e})=>e.some(([t,n])=>t!==0||n!==0)),nm=i=>Math.max(1,...[...i.bodies.values()].flatMap(e=>e.map(t=>t.order)));function im(i,e){let t=64*nm(i),n=[0,0,0],s=0,r=(o,a)=>{if(o.length===1&&o[0].order>0)s=Math.max(s,lR(o,a));else for(let l=0;l<t;l++)s=Math.max(s,Math.hypot(...Us(o,a,2*Math.PI*l/t)))};for(let o of i.ends.values())r(o,n);for(let o of e){let a=i.bodies.get(o.name);if(a)for(let l of sm(o))r(a,l.map((c,h)=>c-o.pole[h]))}return s}function lR(i,e){let[{order:t}]=i,n=Us(i,e,0),s=Us(i,e,Math.PI/2/t),r=(l,c)=>l.reduce((h,u,d)=>h+u*c[d],0),o=r(n,n),a=r(s,s);return Math.sqrt((o+a)/2+Math.hypot((o-a)/2,r(n,s)))}function ov(i,e,t){let n=i.hasSize?im(i,e):0;return n>0&&t>0?`largest displacement ${Qi(n,"m",3)} 0-p, drawn ${je(Number(t.toPrecision(2)),7)} ×`:""}function sm({box:i,pole:e,solids:t}){if(t.length)return t.flatMap(({vertices:s})=>cR(s));if(!i)return[e];let n=[-.5,.5];return n.flatMap(s=>n.flatMap(r=>n.map(o=>[0,1,2].map(a=>i.centre[a]+s*i.size[0]*i.axes[0][a]+r*i.size[1]*i.axes[1][a]+o*i.size[2]*i.axes[2][a]))))}function cR(i){let e=[];for(let t=0;t<3;t++){let[n,s]=[0,0];for(let r=0;r<i.length;r+=3)i[r+t]<i[n+t]&&(n=r),i[r+t]>i[s+t]&&(s=r);for(let r of[n,s])e.push([i[r],i[r+1],i[r+2]])}return e}var Xu=class{constructor(e,t,n,s=[]){this.body=e;this.object=new Pt;this.atRest=new Pt;this.materials=[];if(this.object.matrixAutoUpdate=this.atRest.matrixAutoUpdate=!1,e.solids.length)for(let r of e.solids)this.add(uR(r.vertices,r.triangles,e.pole),n,.75);else e.box?this.add(hR(e),n,.55):e.node&&this.add(new ol(.006*t,12,8),n);if(s.length){let r=new Nt().setFromPoints(s.flat()).translate(...e.pole.map(o=>-o));this.object.add(new gi(r,new _n({color:n.rest})))}this.rest=Jo(e.pole,null,0,0),this.atRest.matrix.copy(this.rest),this.move(null,0,0),this.object.traverse(r=>r.userData={kind:"body",name:e.name})}move(e,t,n){this.object.matrix.copy(Jo(this.body.pole,e,t,n)),this.object.matrixWorldNeedsUpdate=!0}highlight(e,t){for(let n of this.materials)n.emissive.setHex(e?t.selected:0).multiplyScalar(e?.55:1)}dispose(){Ci(this.object),Ci(this.atRest)}add(e,t,n=1){let s=new ir({color:t.body,roughness:.75,metalness:.05,transparent:n<1,opacity:n,depthWrite:n===1,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1}),r=new Lr(e,25);this.materials.push(s),this.object.add(new Mt(e,s),new gi(r,new _n({color:t.edge}))),this.atRest.add(new gi(r,new _n({color:t.rest,transparent:!0,opacity:.45})))}};function Jo(i,e,t,n){let[s,r,o,a,l,c]=e?tm(e,t).map(h=>h*n):[0,0,0,0,0,0];return new St().set(1,-c,l,i[0]+s,c,1,-a,i[1]+r,-l,a,1,i[2]+o,0,0,0,1)}function Ci(i){i.traverse(e=>{let{geometry:t,material:n}=e;t?.dispose();for(let s of[n].flat())s?.map?.dispose(),s?.dispose()})}function hR({box:i,pole:e}){let t=new Vi(...i.size),[n,s,r]=i.axes,o=i.centre.map((a,l)=>a-e[l]);return t.applyMatrix4(new St().set(n[0],s[0],r[0],o[0],n[1],s[1],r[1],o[1],n[2],s[2],r[2],o[2],0,0,0,1)),t}function uR(i,e,t){let n=new Nt;n.setAttribute("position",new pi(Float32Array.from(i,(r,o)=>r-t[o%3]),3)),n.setIndex([...e]);let s=n.toNonIndexed();return n.dispose(),s.computeVertexNormals(),s}var lv={edges:"edges at rest",rest:"machine at rest",strobe:"stroboscope"},av=8,Yu=class{constructor(e,t,n){this.bodies=e;this.elements=t;this.root=new Pt;this.atRest=null;this.flashes=new Pt;this.fill=new Dr({color:n.rest,transparent:!0,opacity:.28,depthWrite:!1}),this.line=new _n({color:n.trace,transparent:!0,opacity:.55,depthWrite:!1}),this.root.add(this.flashes)}show(e,t,n){let s=t!==null&&n>0;if(e!=="edges"&&s&&this.root.add(this.atRest??=this.machineAtRest()),this.atRest&&(this.atRest.visible=e!=="edges"&&s),this.flashes.clear(),!(e!=="strobe"||!s))for(let{body:r,atRest:o}of this.bodies){let a=t.bodies.get(r.name);for(let l=0;a&&l<av;l++)this.flashes.add(this.flash(o,Jo(r.pole,a,2*Math.PI*l/av,n)))}}dispose(){this.fill.dispose(),this.line.dispose()}flash(e,t){let n=new Pt;n.matrixAutoUpdate=!1,n.matrix.copy(t),n.matrixWorldNeedsUpdate=!0;for(let s of e.children)n.add(new gi(s.geometry,this.line));return n}machineAtRest(){let e=new Pt;for(let{object:t,rest:n}of[...this.bodies,...this.elements]){let s=t.clone(!0);s.matrix.copy(n),s.matrixWorldNeedsUpdate=!0;for(let r of dR(s))r.userData={},r instanceof Mt?r.material=this.fill:r instanceof gi&&(r.visible=!1);e.add(s)}return e}};function dR(i){let e=[];return i.traverse(t=>e.push(t)),e}function cv(i,e,{background:t,text:n},s){let r=document.createElement("canvas");[r.width,r.height]=[i.width,i.height];let o=r.getContext("2d");o.drawImage(i,0,0),o.scale(s,s),o.textBaseline="top",o.lineWidth=4,o.lineJoin="round",o.strokeStyle=`#${t.toString(16).padStart(6,"0")}`,o.fillStyle=n;let a=10;return e.forEach((l,c)=>{o.font=`${c?400:650} 15px system-ui, "DejaVu Sans", sans-serif`;for(let h of fR(l,r.width/s-20,u=>o.measureText(u).width))o.strokeText(h,10,a),o.fillText(h,10,a),a+=1.3*15}),r}function fR(i,e,t){let n=[];for(let s of i.split(" ")){let r=n.length?`${n.at(-1)} ${s}`:s;n.length&&t(r)<=e?n[n.length-1]=r:n.push(s)}return n}function hv(i,{elements:e,points:t,forces:n,size:s}){if(i.node)return[];let r=[...e.flatMap(a=>[a.from,a.to].filter(l=>l.body===i.name).map(l=>l.at)),...t.filter(a=>a.body===i.name).map(a=>a.at),...n.filter(a=>a.body===i.name).map(a=>a.at)],o=new Map;for(let a of r){let l=new I(...a),c=pR(i,l);c.distanceTo(l)>1e-6*s&&o.set(a.join(),[c,l])}return[...o.values()]}function pR({box:i,solids:e,centre_of_mass:t},n){if(e.length){let h=new Ei;for(let{vertices:u}of e)for(let d=0;d<u.length;d+=3)h.expandByPoint(new I(...u.slice(d,d+3)));return h.clampPoint(n,new I)}if(!i)return new I(...t);let[s,r,o]=i.axes.map(h=>new I(...h)),a=new St().makeBasis(s,r,o).setPosition(...i.centre),l=new I(...i.size).multiplyScalar(.5);return n.clone().applyMatrix4(a.clone().invert()).clamp(l.clone().negate(),l).applyMatrix4(a)}var Zu=class extends Qn{constructor(t,n){super();this.coil=t;this.length=n;this.turns=t.turns+t.dead_turns[0]+t.dead_turns[1]}getPoint(t,n=new I){let{mean_diameter:s,turns:r,dead_turns:[o],left_handed:a,start_angle:l}=this.coil,c=t*this.turns,h=l+(a?-1:1)*2*Math.PI*c,u=Math.min(Math.max((c-o)/r,0),1);return n.set(s/2*Math.cos(h),s/2*Math.sin(h),this.length*u)}};function uv(i,e,t,n){let s=new ir({color:n.mount,roughness:.9}),r=new ir({color:n.metal,roughness:.5}),o=i.size[1],a=o?o/2:Math.min(Math.max(.45*e,.015*t),.025*t);return(rm[i.kind]??mR)(i,{length:e,radius:a,rubber:s,metal:r})}var mR=(i,e)=>[new Mt(am([[1,0],[.86,.25],[.78,.5],[.86,.75],[1,1]],e),e.rubber),...om(e)],rm={coil:({coil:i},e)=>{let t=new Zu(i??{mean_diameter:1.7*e.radius,turns:6,dead_turns:[0,0],left_handed:!1,start_angle:0},e.length),n=i?Math.min(i.wire[0],i.wire[1])/2:.12*e.radius;return[new Mt(new ll(t,Math.ceil(24*t.turns),n,8),e.metal)]},rubber:({rubber:i},e)=>{let t=i?.layers??[{thickness:1,metal:!1}],n=t.reduce((r,o)=>r+o.thickness,0),s=0;return t.map(({thickness:r,metal:o})=>{let a=e.length*r/n,l=s+a/2;s+=a;let[c,h]=i?.widths??[],u=c&&h?new Vi(c,h,a).translate(0,0,l):Os((i?.diameter??2*e.radius)/2,a,l);return new Mt(u,o?e.metal:e.rubber)})},bush:({rubber:i},{length:e,radius:t,rubber:n,metal:s})=>{let r=(i?.outer_diameter??2*t)/2,o=(i?.inner_diameter??t)/2;return[new Mt(Os(r,.9*e,e/2),n),new Mt(Os(o,1.15*e,e/2),s)]},beam:({section:i},{length:e,radius:t,metal:n})=>{let[s,r]=i?.widths??[];return[new Mt(s&&r?new Vi(s,r,e).translate(0,0,e/2):Os((i?.outer_diameter??t)/2,e,e/2),n)]},rod:(i,{length:e,radius:t,metal:n})=>[new Mt(Os(.3*t,e,e/2),n)],damper:(i,{length:e,radius:t,rubber:n,metal:s})=>[new Mt(Os(.62*t,.55*e,.3*e),s),new Mt(Os(.24*t,e,.5*e),n)],strut:(i,e)=>[...rm.coil(i,e),...rm.damper(i,e)],stop:(i,e)=>[new Mt(am([[.95,0],[.8,.3],[.25,.62]],e),e.rubber),new Mt(Os(e.radius,.1*e.length,.95*e.length),e.metal)],air_spring:(i,e)=>[new Mt(am([[.8,0],[1.15,.25],[.85,.5],[1.15,.75],[.8,1]],e),e.rubber),...om(e)],wire_rope:(i,e)=>[...[-.5,0,.5].map(t=>{let n=new al(.45*e.length,.07*e.length,8,24).rotateY(Math.PI/2);return new Mt(n.translate(t*e.radius,0,e.length/2),e.metal)}),...om(e)]},Os=(i,e,t)=>new nr(i,i,e,32).rotateX(Math.PI/2).translate(0,0,t),om=({radius:i,length:e,metal:t})=>[.03,.97].map(n=>new Mt(Os(1.12*i,.06*e,n*e),t));function am(i,{radius:e,length:t}){let n=Array.from({length:17},(s,r)=>{let[o,a]=[i[0][1],i.at(-1)[1]],l=o+(a-o)*r/16,c=Math.max(1,i.findIndex(_=>_[1]>=l-1e-9)),[h,u]=i[c-1],[d,f]=i[c],p=(1-Math.cos(Math.PI*(l-u)/(f-u)))/2;return new Me(e*(h+(d-h)*p),t*l)});return new il(n,32).rotateX(Math.PI/2)}function lm(i,e){let t=document.createElement("canvas");t.width=t.height=64,i(t.getContext("2d"),64);let n=new Za(new Vo({map:new Ja(t),depthTest:!1,sizeAttenuation:!1,transparent:!0,toneMapped:!1}));return n.scale.setScalar(e),n.renderOrder=10,n}function dv(i){return lm((e,t)=>{let n=t/2,s=.4*t;for(let r=0;r<4;r++)e.beginPath(),e.moveTo(n,n),e.arc(n,n,s,r*Math.PI/2,(r+1)*Math.PI/2),e.fillStyle=r%2?"#fff":"#111",e.fill();e.strokeStyle=i.text,e.lineWidth=3,e.beginPath(),e.arc(n,n,s,0,2*Math.PI),e.stroke()},.022)}function fv(i){return lm((e,t)=>{e.beginPath(),e.arc(t/2,t/2,.3*t,0,2*Math.PI),e.fillStyle=`#${i.trace.toString(16).padStart(6,"0")}`,e.fill(),e.strokeStyle="#fff",e.lineWidth=6,e.stroke()},.016)}function gR(i,e){return lm((t,n)=>{t.font=`600 ${.7*n}px system-ui, sans-serif`,t.textAlign="center",t.textBaseline="middle",t.fillStyle=e.text,t.fillText(i,n/2,n/2)},.03)}function pv(i,e){let t=new Pt;return["x","y","z"].forEach((n,s)=>{let r=new I().setComponent(s,1),o=gR(n,e);o.scale.setScalar(.45*i),t.add(new Is(r,new I,i,e.edge,.22*i,.1*i),o),o.position.copy(r).multiplyScalar(1.25*i)}),t}function mv({direction:i,gap:e,kind:t},n,s){let r=new Pt,o=new I(...i),a=e<=0,l=new Rs({color:a?s.force:s.selected,side:Ai,transparent:!0,opacity:.75}),c=.028*n,h=t==="ring"?new rl(c,1.15*c,36):new el(c,28),u=new Mt(h,l);return u.quaternion.copy(new Mn().setFromUnitVectors(new I(0,0,1),o)),t!=="ring"&&u.position.copy(o).multiplyScalar(Math.max(e,0)),r.add(u),r}function gv({from:i,to:e},t){let n=[new I(...i.at),new I(...e.at)],s=new Ti(new Nt().setFromPoints(n),new _n({color:t.selected,depthTest:!1}));return s.renderOrder=7,s}function _v(i,e,t){let n=new Pt,s=.012*i,r=new nr(.045*i,.045*i,s,28).translate(0,-s/2,0);return r.applyQuaternion(new Mn().setFromUnitVectors(new I(0,1,0),e)),n.matrixAutoUpdate=!1,n.add(new Mt(r,new Dr({color:t.rest})),new gi(new Lr(r,25),new _n({color:t.edge}))),n}function yv(i,e,t,n,s){let r=10**Math.round(Math.log10(t/6)),o=Math.ceil(2.6*t/r),a=new ml(o*r,o,s.grid,s.grid);return a.quaternion.copy(new Mn().setFromUnitVectors(new I(0,1,0),n)),a.position.copy(e).addScaledVector(n,i-e.dot(n)),a}function xv(i,e,t,n,s){let r=i.map((u,d)=>u-e.pole[d]),o=t.bodies.get(e.name),a=[],l=Math.max(72,16*nm(t));for(let u=0;o&&u<=l;u++){let d=Us(o,r,2*Math.PI*u/l);a.push(...d.map((f,p)=>i[p]+n*f))}let c=new Nt;c.setAttribute("position",new ut(a,3));let h=new Ti(c,new _n({color:s.trace,depthTest:!1}));return h.renderOrder=9,h}var ju=class{constructor(e,t,n,s,r){this.element=e;this.object=new Pt;this.object.matrixAutoUpdate=!1;let[o,a,l]=e.axes.map(_=>new I(..._)),c=new I(...e.from.at),h=new I(...e.to.at),u=e.rubber?.length;if(u)vv(c,h,l,u/2,u/2);else if(c.distanceTo(h)<.01*n){let _=Math.min(Math.max(e.size[0],.07*n),.12*n),m=l.clone().multiplyScalar(_R(e,t,l));e.from.body&&e.to.body?vv(c,h,l,_/2,_/2):e.from.body?h.addScaledVector(m,_):c.addScaledVector(m,_)}this.ends={from:c,to:h},this.length=Math.max(c.distanceTo(h),1e-9);let d=h.clone().sub(c).normalize(),f=Math.abs(d.dot(l))>.99,p=f?o:new I().crossVectors(Math.abs(d.x)<.9?new I(1,0,0):new I(0,1,0),d).normalize();this.across=[p,f&&d.dot(l)>0?a:d.clone().cross(p)],this.object.add(...uv(e,this.length,n,r)),this.object.traverse(_=>_.userData={kind:"element",name:e.name}),this.place(c,h),this.rest=this.object.matrix.clone(),this.foot=e.from.body?null:_v(n,s,r),this.foot&&this.foot.traverse(_=>_.userData={kind:"element",name:e.name}),this.move(null,t,0,0)}move(e,t,n,s){let{element:{from:r,to:o,name:a},ends:l,foot:c}=this;if(this.place(bv(l.from,r,e,t,n,s,`${a}.foot`),bv(l.to,o,e,t,n,s,`${a}.head`)),!c)return;let h=e?.ends.get(`${a}.foot`)??null,{x:u,y:d,z:f}=l.from;for(let p of c.children)p.visible=r.foundation!==void 0||h!==null;c.matrix.copy(Jo([u,d,f],h,n,s)),c.matrixWorldNeedsUpdate=!0}highlight(e,t){this.object.traverse(n=>{n.material?.emissive?.setHex(e?t.selected:0).multiplyScalar(e?.7:1)})}paint(e){this.object.traverse(t=>{let n=t.material;if(!n?.color)return;let s=n.userData.own??=n.color.clone();n.color.copy(e??s)})}dispose(){Ci(this.object),this.foot&&Ci(this.foot)}place(e,t){let n=t.clone().sub(e).divideScalar(this.length),[s,r]=this.across;this.object.matrix.copy(new St().makeBasis(s,r,n).setPosition(e)),this.object.matrixWorldNeedsUpdate=!0}},vv=(i,e,t,n,s)=>{i.addScaledVector(t,-n),e.addScaledVector(t,s)};function bv(i,e,t,n,s,r,o){if(!t)return i;let a=n.get(e.body??""),l=a?t.bodies.get(a.name):t.ends.get(o);if(!l)return i;let c=a?e.at.map((h,u)=>h-a.pole[u]):[0,0,0];return i.clone().addScaledVector(new I(...Us(l,c,s)),r)}function _R({from:i,to:e},t,n){let s=t.get(e.body??"")??t.get(i.body??""),r=s?n.dot(new I(...e.at).sub(new I(...s.centre_of_mass))):0;return r>1e-9?1:r<-1e-9||n.z>0?-1:1}function Sv(i,e,t){let n=new I(...i.direction);n.lengthSq()===0&&n.set(0,0,1),n.normalize();let s=i.kind==="force"||i.kind==="ground_translation"?yR(n,e,t.force):cm(n,(i.kind==="rotating_force"?.05:.09)*e,t.force);return s.traverse(r=>{r.userData={kind:"force",name:i.name},r.renderOrder=8;let o=r.material;o&&(o.depthTest=!1)}),s}function yR(i,e,t){let n=new Pt,s=.18*e;return n.add(new Is(i,i.clone().multiplyScalar(-s),s,t,.04*e,.022*e)),n}function cm(i,e,t){let n=new Pt,s=1.55*Math.PI,r=Array.from({length:41},(a,l)=>new I(e*Math.cos(s*l/40),e*Math.sin(s*l/40),0)),o=new Mt(new Go(.2*e,.5*e,14),new Rs({color:t}));return o.position.copy(r.at(-1)),o.rotation.z=s,n.add(new Ti(new Nt().setFromPoints(r),new _n({color:t})),o),n.quaternion.copy(new Mn().setFromUnitVectors(new I(0,0,1),i)),n}function Mv({direction:i,point:e,pitch:t},n,s,r){let o=new Pt,a=new I(...i),l=e?new I(...e):n;if(e){let u=[-.6,.6].map(f=>l.clone().addScaledVector(a,f*s)),d=cm(a,.09*s,r.selected);d.position.copy(l),o.add(new Ti(new Nt().setFromPoints(u),new _n({color:r.selected})),d)}let c=a.clone().multiplyScalar(t!==null&&t<0?-1:1),h=e?.14*s:.3*s;return(!e||Math.abs(t??0)>.001*s)&&o.add(new Is(c,l,h,r.selected,.05*s,.026*s)),o.traverse(u=>{u.renderOrder=9;let d=u.material;d&&(d.depthTest=!1)}),o}function wv(i,e){Ci(i),i.clear(),e&&i.add(e)}var Ju=class{constructor(e,t){this.scene=e;this.colours=t;this.root=new Pt;this.bounds=new Ei;this.followers=[];this.rest=new Pt;this.traces=new Pt;this.screw=new Pt;let n=e.gravity&&Math.hypot(...e.gravity)>0?new I(...e.gravity).negate().normalize():new I(0,0,1);this.byName=new Map(e.bodies.map(o=>[o.name,o])),this.bodies=e.bodies.map(o=>new Xu(o,e.size,t,hv(o,e))),this.elements=e.elements.map(o=>new ju(o,this.byName,e.size,n,t)),this.ghosts=new Yu(this.bodies,this.elements,t);for(let{object:o,atRest:a}of this.bodies)this.root.add(o),this.rest.add(a);for(let{object:o,foot:a}of this.elements)this.root.add(o,...a?[a]:[]);this.root.add(this.rest,this.traces,this.ghosts.root,this.screw);for(let o of e.bodies.filter(a=>!a.node))this.follow(dv(t),o,o.centre_of_mass,{kind:"body",name:o.name});for(let o of e.points){let a=this.byName.get(o.body);a&&this.follow(fv(t),a,o.at,{kind:"point",name:o.name})}for(let o of e.forces){let a=this.byName.get(o.body??""),l=Sv(o,e.size,t);l.position.set(...o.at),a?this.follow(l,a,o.at,{kind:"force",name:o.name}):this.root.add(l)}for(let o of e.stops){let a=mv(o,e.size,t);a.position.set(...o.at),a.traverse(l=>l.userData={kind:"element",name:o.name}),this.root.add(a)}for(let o of e.clearances)this.root.add(gv(o,t));this.root.updateMatrixWorld(!0),this.measure();let s=this.bounds.getCenter(new I),r=xR(this.bounds,n);this.root.add(yv(r,s,e.size,n,t))}scaleFor(e,t){let n=im(e,this.scene.bodies);return n>0?t*this.scene.size/n:0}move(e,t,n){for(let s of this.bodies)s.move(e?.bodies.get(s.body.name)??null,t,n);for(let s of this.elements)s.move(e,this.byName,t,n);for(let{object:s,body:r,at:o,rest:a}of this.followers){let l=e?.bodies.get(r.name),c=o.map((h,u)=>h-r.pole[u]);s.position.copy(a),l&&s.position.addScaledVector(new I(...Us(l,c,t)),n)}this.rest.visible=e!==null&&n>0}showTraces(e,t){if(Ci(this.traces),this.traces.clear(),!!e)for(let n of this.scene.bodies){let s=this.scene.points.filter(r=>r.body===n.name).map(r=>r.at);for(let r of[...s,n.centre_of_mass,...sm(n).slice(-4)])this.traces.add(xv(r,n,e,t,this.colours))}}showGhosts(e,t,n){this.ghosts.show(e,t,n)}showScrew(e,t){wv(this.screw,e&&t&&Mv(e,new I(...t.centre_of_mass),this.scene.size,this.colours))}highlight(e){for(let t of this.bodies)t.highlight(e?.kind==="body"&&e.name===t.body.name,this.colours);for(let t of this.elements)t.highlight(e?.kind==="element"&&e.name===t.element.name,this.colours)}colour(e){for(let t of this.elements){let n=e?.values.get(t.element.name);t.paint(n===void 0?null:Wx(n,e))}}dispose(){Ci(this.root),this.ghosts.dispose()}follow(e,t,n,s){let r=new I(...n);e.position.copy(r),e.traverse(o=>o.userData=s),this.followers.push({object:e,body:t,at:n,rest:r}),this.root.add(e)}measure(){for(let{object:e}of[...this.bodies,...this.elements])this.bounds.expandByObject(e);for(let{rest:e}of this.followers)this.bounds.expandByPoint(e);this.bounds.isEmpty()&&this.bounds.expandByPoint(new I)}},xR=({min:i,max:e},t)=>[0,1,2].reduce((n,s)=>{let r=t.getComponent(s);return n+r*(r>0?i:e).getComponent(s)},0);var Ev={type:"change"},um={type:"start"},Av={type:"end"},Ku=new er,Tv=new fi,vR=Math.cos(70*Np.DEG2RAD),An=new I,ti=2*Math.PI,It={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},hm=1e-6,Qu=class extends gl{constructor(e,t=null){super(e,t),this.state=It.NONE,this.target=new I,this.cursor=new I,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:ar.ROTATE,MIDDLE:ar.DOLLY,RIGHT:ar.PAN},this.touches={ONE:lr.ROTATE,TWO:lr.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new I,this._lastQuaternion=new Mn,this._lastTargetPosition=new I,this._quat=new Mn().setFromUnitVectors(e.up,new I(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new Wo,this._sphericalDelta=new Wo,this._scale=1,this._panOffset=new I,this._rotateStart=new Me,this._rotateEnd=new Me,this._rotateDelta=new Me,this._panStart=new Me,this._panEnd=new Me,this._panDelta=new Me,this._dollyStart=new Me,this._dollyEnd=new Me,this._dollyDelta=new Me,this._dollyDirection=new I,this._mouse=new Me,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=SR.bind(this),this._onPointerDown=bR.bind(this),this._onPointerUp=MR.bind(this),this._onContextMenu=PR.bind(this),this._onMouseWheel=TR.bind(this),this._onKeyDown=AR.bind(this),this._onTouchStart=CR.bind(this),this._onTouchMove=RR.bind(this),this._onMouseDown=wR.bind(this),this._onMouseMove=ER.bind(this),this._interceptControlDown=IR.bind(this),this._interceptControlUp=LR.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(e){this._cursorStyle=e,e==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=It.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(Ev),this.update(),this.state=It.NONE}pan(e,t){this._pan(e,t),this.update()}dollyIn(e){this._dollyIn(e),this.update()}dollyOut(e){this._dollyOut(e),this.update()}rotateLeft(e){this._rotateLeft(e),this.update()}rotateUp(e){this._rotateUp(e),this.update()}update(e=null){let t=this.object.position;An.copy(t).sub(this.target),An.applyQuaternion(this._quat),this._spherical.setFromVector3(An),this.autoRotate&&this.state===It.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(n)&&isFinite(s)&&(n<-Math.PI?n+=ti:n>Math.PI&&(n-=ti),s<-Math.PI?s+=ti:s>Math.PI&&(s-=ti),n<=s?this._spherical.theta=Math.max(n,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+s)/2?Math.max(n,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(An.setFromSpherical(this._spherical),An.applyQuaternion(this._quatInverse),t.copy(this.target).add(An),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=An.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new I(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new I(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=An.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(Ku.origin.copy(this.object.position),Ku.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Ku.direction))<vR?this.object.lookAt(this.target):(Tv.setFromNormalAndCoplanarPoint(this.object.up,this.target),Ku.intersectPlane(Tv,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>hm||8*(1-this._lastQuaternion.dot(this.object.quaternion))>hm||this._lastTargetPosition.distanceToSquared(this.target)>hm?(this.dispatchEvent(Ev),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?ti/60*this.autoRotateSpeed*e:ti/60/60*this.autoRotateSpeed}_getZoomScale(e){let t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){An.setFromMatrixColumn(t,0),An.multiplyScalar(-e),this._panOffset.add(An)}_panUp(e,t){this.screenSpacePanning===!0?An.setFromMatrixColumn(t,1):(An.setFromMatrixColumn(t,0),An.crossVectors(this.object.up,An)),An.multiplyScalar(e),this._panOffset.add(An)}_pan(e,t){let n=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;An.copy(s).sub(this.target);let r=An.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*r/n.clientHeight,this.object.matrix),this._panUp(2*t*r/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),s=e-n.left,r=t-n.top,o=n.width,a=n.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientY),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(ti*this._rotateDelta.x/t.clientHeight),this._rotateUp(ti*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(ti*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-ti*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(ti*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-ti*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._rotateStart.set(n,s)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panStart.set(n,s)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(n*n+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let n=this._getSecondPointerPosition(e),s=.5*(e.pageX+n.x),r=.5*(e.pageY+n.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(ti*this._rotateDelta.x/t.clientHeight),this._rotateUp(ti*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panEnd.set(n,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(n*n+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(e.pageX+t.x)*.5,a=(e.pageY+t.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new Me,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,n={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function bR(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function SR(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function MR(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(Av),this.state=It.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function wR(i){let e;switch(i.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case ar.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=It.DOLLY;break;case ar.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=It.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=It.ROTATE}break;case ar.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=It.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=It.PAN}break;default:this.state=It.NONE}this.state!==It.NONE&&this.dispatchEvent(um)}function ER(i){switch(this.state){case It.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case It.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case It.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function TR(i){this.enabled===!1||this.enableZoom===!1||this.state!==It.NONE||(i.preventDefault(),this.dispatchEvent(um),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent(Av))}function AR(i){this.enabled!==!1&&this._handleKeyDown(i)}function CR(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case lr.ROTATE:if(this.enableRotate===!1){this.state=It.NONE;break}this._handleTouchStartRotate(i),this.state=It.TOUCH_ROTATE;break;case lr.PAN:if(this.enablePan===!1){this.state=It.NONE;break}this._handleTouchStartPan(i),this.state=It.TOUCH_PAN;break;default:this.state=It.NONE}break;case 2:switch(this.touches.TWO){case lr.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=It.TOUCH_DOLLY_PAN;break;case lr.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=It.TOUCH_DOLLY_ROTATE;break;default:this.state=It.NONE}break;default:this.state=It.NONE}this.state!==It.NONE&&this.dispatchEvent(um)}function RR(i){switch(this._trackPointer(i),this.state){case It.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case It.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case It.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case It.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=It.NONE}}function PR(i){this.enabled!==!1&&i.preventDefault()}function IR(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function LR(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var DR={oblique:[.75,-1,.55],front:[0,-1,0],side:[1,0,0],top:[0,0,1]},NR=8,dm=.05,fm=.5,UR=4,ed=class{constructor(e,t,n){this.beforeFrame=n;this.camera=new Zn(28,1,.01,100);this.scene=new zo;this.light=new fl(16777215,2);this.machine=null;this.corner=new zo;this.cornerCamera=new Nr(-1.6,1.6,1.6,-1.6,.1,10);this.wanted=!1;this.isBehind=!1;this.isMeasuring=!1;this.isDisposed=!1;this.share=fm;this.taken={until:0,time:0};this.renderer=new Gu({canvas:e,antialias:!0}),this.renderer.setPixelRatio(Math.min(devicePixelRatio,2)),this.renderer.setClearColor(t),this.camera.up.set(0,0,1),this.controls=new Qu(this.camera,e),this.controls.addEventListener("change",()=>this.draw()),this.scene.add(new ul(16777215,8952234,1.6),this.light)}show(e,t,n){this.machine&&this.scene.remove(this.machine.root),this.machine?.dispose(),this.machine=e,this.scene.add(e.root),this.renderer.setClearColor(t.background),Ci(this.corner),this.corner.clear(),this.corner.add(pv(1,t)),n&&this.look("oblique"),this.draw()}look(e){if(!this.machine)return;let t=this.machine.bounds.getBoundingSphere(new Cs),n=t.radius*this.reach(),s=new I(...DR[e]).normalize();e==="top"&&s.add(new I(0,-.001,0)),this.controls.target.copy(t.center),this.camera.position.copy(t.center).addScaledVector(s,n),[this.camera.near,this.camera.far]=[n/50,n*20],this.camera.updateProjectionMatrix(),this.controls.update(),this.draw()}turn(e,t,n=1){let{target:s}=this.controls,r=this.camera.position.clone().sub(s).multiplyScalar(n),o=new I().crossVectors(this.camera.up,r).normalize();r.applyAxisAngle(this.camera.up,e);let a=r.angleTo(this.camera.up);a-t>.05&&a-t<Math.PI-.05&&r.applyAxisAngle(o.applyAxisAngle(this.camera.up,e),-t),this.camera.position.copy(s).add(r),this.controls.update(),this.draw()}reach(){let e=this.camera.fov*Math.PI/360,t=Math.min(e,Math.atan(Math.tan(e)*this.camera.aspect));return 1.02/Math.sin(t)}resize(e,t){if(e<1||t<1)return;this.renderer.setSize(e,t,!1);let n=this.reach();this.camera.aspect=e/t,this.camera.updateProjectionMatrix();let s=this.camera.position.clone().sub(this.controls.target).multiplyScalar(this.reach()/n);this.camera.position.copy(this.controls.target).add(s),this.draw()}draw(){this.isBehind=!1,!this.wanted&&(this.wanted=!0,requestAnimationFrame(()=>{this.wanted=!1,this.isDisposed||this.drawNow()}))}drawWhenFree(e){this.isBehind=!0,this.share=e,!(this.isMeasuring||this.later!==void 0)&&(this.later=setTimeout(()=>{this.later=void 0,this.draw(),this.isMeasuring=!0,requestAnimationFrame(()=>this.isDisposed||this.measure(performance.now()))},Math.max(0,this.taken.until+this.taken.time*(1/e-1)-performance.now())))}measure(e){let t=this.renderer.getContext(),n=t.fenceSync(t.SYNC_GPU_COMMANDS_COMPLETE,0);t.flush();let s=()=>{if(this.isDisposed)return;if(n&&!t.isContextLost()&&t.clientWaitSync(n,0,0)===t.TIMEOUT_EXPIRED)return void setTimeout(s,UR);t.deleteSync(n);let r=performance.now(),o=r-e;this.taken={until:r,time:o<NR?0:o},this.isMeasuring=!1,this.isBehind&&this.drawWhenFree(this.share)};s()}drawNow(){this.beforeFrame(),this.light.position.copy(this.camera.position).add(new I(0,0,this.camera.position.length())),this.renderer.render(this.scene,this.camera),this.drawCorner()}drawCorner(){let{x:t}=this.renderer.getSize(new Me);this.cornerCamera.up.copy(this.camera.up),this.cornerCamera.position.copy(this.camera.position).sub(this.controls.target).setLength(5),this.cornerCamera.lookAt(0,0,0),this.renderer.autoClear=!1,this.renderer.setViewport(t-84,0,84,84),this.renderer.clearDepth(),this.renderer.render(this.corner,this.cornerCamera),this.renderer.setViewport(0,0,t,this.renderer.getSize(new Me).y),this.renderer.autoClear=!0}pick(e,t){let n=new pl;if(n.setFromCamera(new Me(e,t),this.camera),!this.machine)return null;let s=n.intersectObjects(this.machine.root.children,!0).find(r=>r.object.userData.kind&&r.object.visible&&r.object.type!=="LineSegments");return s?s.object.userData:null}dispose(){this.isDisposed=!0,clearTimeout(this.later),this.machine?.dispose(),this.controls.dispose(),this.renderer.dispose()}};function Cv(i,e,t){let n=i.modes.find(o=>o.number===e)?.screws?.[i.bodies.indexOf(t.name)];if(!n||Math.hypot(...n.direction)===0)return null;let s=o=>[0,1,2].map(a=>t.axes.reduce((l,c,h)=>l+c[a]*o[h],0)),r=n.point&&s(n.point).map((o,a)=>o+t.pole[a]);return{direction:s(n.direction),point:r,pitch:n.pitch}}function Rv({point:i,pitch:e},{centre_of_mass:t}){if(!i)return"translation without rotation";let n=Math.hypot(...i.map((s,r)=>s-t[r]));return`screw axis ${Qi(n,"m",3)} from the centre of mass, pitch ${Qi(Math.abs(e)<1e-9?0:e,"m",3)}/rad`}var OR=1e-9;function FR(i,e){if(i.over!=="frequency")return!1;let t=i.points.map(n=>n.angular_frequency);return e>=Math.min(...t)&&e<=Math.max(...t)}function td(i,e){return i?.at?.find(t=>Math.abs(t.angular_frequency-e)<=OR*e)?.motions??null}function pm({stable:i,periods:e}){let t=i===null?"of uncertain stability":i?"stable":"unstable";return e>1?`${t}, ${e} periods`:t}function kR(i){let e=n=>n.results[0]?n.results[0].largest-n.results[0].smallest:0,t=i.over==="frequency"?i.points.filter(n=>n.stable):[];return t.length?t.reduce((n,s)=>e(s)>e(n)?s:n).angular_frequency:null}function Pv(i,e){return td(i.result("steady"),e)?"no such steady motion is known here":i.failure("steady")||"steady motion: computing …"}function mm(i,{shown:e,frequencyUnit:t}){if(!i)return[];let n="omega"in e&&FR(i,e.omega)?e.omega:kR(i);if(n===null)return[];let s=es(n,t),r=td(i,n);return r?r.map((o,a)=>({omega:n,motion:a,words:`steady motion${r.length>1?` ${a+1}`:""} at ${s}, ${pm(o)}`})):[{omega:n,motion:0,words:`steady motion at ${s}`}]}var nd=class{constructor(){this.from=[];this.motion=null}of({asker:e,display:{shown:t,damped:n}}){let s=e.result("scene"),r=e.result("modes"),o=n?e.result("roots"):null,a=t.kind==="frequency"?e.result("shapes"):null,l=t.kind==="steady"?e.result("steady"):null,c=[t,s,r,o,a,l];if(c.every((u,d)=>u===this.from[d])&&this.from.length)return this.motion;this.from=c;let h=s?.bodies??[];if(t.kind==="steady"){let u=td(l,t.omega),d=u?.[t.motion];this.motion=d?sv(d,t.omega,`${u.length>1?`${t.motion+1} of ${u.length}, `:""}${pm(d)}`,h):null}else if(t.kind==="frequency")this.motion=a&&iv(a,h);else if(t.kind==="rest"||!r)this.motion=null;else{let u=r.modes.findIndex(f=>f.number===t.number),d=o&&nv(o,t.number,h);this.motion=d?{...d,words:r.modes[u]?.name??""}:tv(r,u,h)}return this.motion}};var BR={rgb:0,bt709:1,bt470bg:5,smpte170m:6},zR={bt709:1,smpte170m:6,"iec61966-2-1":13},VR={bt709:1,bt470bg:5,smpte170m:6},gm=2;function Iv(i){let{frames:e,frameDuration:t}=i,n=Et(440786851,Et(17030,ln(1)),Et(17143,ln(1)),Et(17138,ln(4)),Et(17139,ln(8)),Et(17026,id("webm")),Et(17031,ln(4)),Et(17029,ln(2))),s=Et(357149030,Et(2807729,ln(1e6)),Et(17545,$R(e.length*t)),Et(19840,id("Trivet")),Et(22337,id("Trivet")));return Lv([n,Et(408125543,s,GR(i),...WR(i))])}var GR=({codec:i,width:e,height:t,frameDuration:n,colours:s})=>Et(374648427,Et(174,Et(215,ln(1)),Et(29637,ln(1)),Et(131,ln(1)),Et(156,ln(0)),Et(134,id(i)),Et(2352003,ln(n*1e6)),Et(224,Et(176,ln(e)),Et(186,ln(t)),HR(s)))),HR=({matrix:i,transfer:e,primaries:t,fullRange:n})=>Et(21936,Et(21937,ln(BR[i??""]??gm)),Et(21945,ln(n?2:1)),Et(21946,ln(zR[e??""]??gm)),Et(21947,ln(VR[t??""]??gm)));function WR({frames:i,frameDuration:e}){let t=[];return i.forEach(({data:n,key:s},r)=>{let o=r*e;(s||o-t.at(-1).begin>32767)&&t.push({begin:o,blocks:[]});let{begin:a,blocks:l}=t.at(-1),c=o-a;l.push(Et(163,Uint8Array.of(129,c>>8,c&255,s?128:0),n))}),t.map(({begin:n,blocks:s})=>Et(524531317,Et(231,ln(n)),...s))}function Et(i,...e){let t=ln(e.reduce((s,r)=>s+r.length,0)),n=new Uint8Array(8);return n[0]=1,n.set(t,8-t.length),Lv([ln(i),n,...e])}function ln(i){let e=[];do e.unshift(i%256),i=Math.floor(i/256);while(i>0);return Uint8Array.from(e)}function $R(i){let e=new Uint8Array(8);return new DataView(e.buffer).setFloat64(0,i),e}var id=i=>new TextEncoder().encode(i);function Lv(i){let e=new Uint8Array(i.reduce((n,s)=>n+s.length,0)),t=0;for(let n of i)e.set(n,t),t+=n.length;return e}function _m(i){let e=Math.max(24,Math.round(30*i));return{count:e,frameDuration:Math.max(1,Math.round(1e3*i/e))}}var ym=()=>typeof VideoEncoder<"u",qR=[{codec:"vp8",name:"V_VP8"},{codec:"vp09.00.41.08",name:"V_VP9"}];async function Dv(i,e,t){let{count:n,frameDuration:s}=_m(e),r=_=>_-_%2;t(0);let[o,a]=[r(i.width),r(i.height)],l={width:o,height:a,framerate:1e3/s,bitrate:Math.max(2e6,.15*o*a*1e3/s)},c=await XR(l);if(!c)throw new Error("This browser encodes neither VP8 nor VP9.");let h=[],u=null,d={},f=new VideoEncoder({output:(_,m)=>{d=m?.decoderConfig?.colorSpace??d;let g=new Uint8Array(_.byteLength);_.copyTo(g),h.push({data:g,key:_.type==="key"})},error:_=>{u=_}});f.configure({...l,codec:c.codec});for(let _=0;_<n&&!u;_++){t(_/n);let m=new VideoFrame(i,{timestamp:1e3*_*s,duration:1e3*s,alpha:"discard",visibleRect:{x:0,y:0,width:o,height:a}});for(f.encode(m,{keyFrame:_===0}),m.close();f.encodeQueueSize>2;)await new Promise(g=>setTimeout(g,4))}if(u||await f.flush(),u)throw u;f.close();let p={codec:c.name,width:o,height:a,frameDuration:s,frames:h,colours:d};return Iv(p)}async function XR(i){for(let e of qR)if((await VideoEncoder.isConfigSupported({...i,codec:e.codec})).supported)return e;return null}var YR={ArrowLeft:[-.15,0,1],ArrowRight:[.15,0,1],ArrowUp:[0,.12,1],ArrowDown:[0,-.12,1],"+":[0,0,.8695652173913044],"-":[0,0,1.15]};function Nv(i,{display:e,asker:t,state:n},s){if(i.ctrlKey||i.metaKey||i.altKey)return;let r=YR[i.key],o=t.result("modes")?.modes.length??0,a=e.shown.kind==="mode"?e.shown.number:0;if(r)s?.turn(...r);else if(i.key==="Home")s?.look("oblique");else if(i.key===" ")e.set({playing:!e.playing});else if(i.key==="n"&&o)e.set({shown:{kind:"mode",number:Math.min(a+1,o)}});else if(i.key==="p"&&o)e.set({shown:{kind:"mode",number:Math.max(a-1,1)}});else if(i.key==="s")n.select(ZR(t.result("scene"),n.selection));else return;i.preventDefault()}function ZR(i,e){if(!i)return null;let t=[...i.bodies.map(s=>({kind:"body",name:s.name})),...i.elements.map(s=>({kind:"element",name:s.name}))],n=t.findIndex(s=>s.kind===e?.kind&&s.name===e.name);return t[n+1]??null}var xm=class extends vn{constructor(){super(...arguments);this.stage=null;this.machine=null;this.drawn={scene:null,key:""};this.shownMotion=new nd;this.sized=[];this.traced=[];this.marked=[];this.pictured={hand:[],numbers:[]};this.fitted=null;this.motion=null;this.scale=0;this.last=0;this.watcher=null;this.hovered="";this.recording=!1;this.down=[0,0]}render(){let{display:t,asker:n,state:s}=this.app,r=n.result("modes"),{shown:o}=t,a=mm(n.result("steady"),t),l=o.kind==="mode"?`${o.number}`:o.kind==="steady"?`steady ${o.motion}`:o.kind,c=this.label(),[h,u]=this.screw(),d=o.kind==="steady"?"steady":o.kind==="frequency"?"shapes":"modes",f=["oblique","front","side","top"];return ae`
      <div class="stage" tabindex="0" role="application" aria-label="Machine in 3D: ${c}. Arrow keys turn it, plus and minus zoom, space plays or stops, n and p show the next and the previous mode, s selects the next part."
           @keydown=${p=>Nv(p,this.app,this.stage)}>
        <canvas class="machine" @pointerdown=${this.pressed} @pointerup=${this.released} @pointermove=${this.moved}></canvas>
        <div class="caption" aria-hidden="true">${c}${n.isOld(d)?ae` <span class="old">…</span>`:Ue}</div>
        ${this.legend()}
        <div class="hover" aria-hidden="true">${this.hovered||s.selection?.name||""}${h&&!this.hovered?ae` · ${Rv(h,u)}`:Ue}</div>
        ${n.result("scene")?Ue:ae`<p class="missing">${n.missing("scene")}</p>`}
      </div>
      <div class="bar">
        <button class="play" aria-pressed=${t.playing} title="Play or stop (space)" @click=${()=>t.set({playing:!t.playing})}>
          ${t.playing?"❚❚":"▶"}<span class="hidden">${t.playing?"Stop":"Play"}</span></button>
        <select aria-label="Motion" .value=${l} @change=${this.choose}>
          ${r?.modes.map(p=>ae`<option value=${p.number} ?selected=${l===`${p.number}`}>${p.number} · ${es(p.angular_frequency,t.frequencyUnit)} · ${p.name}</option>`)}
          ${"omega"in o?ae`<option value="frequency" ?selected=${l==="frequency"}>operating shape at ${es(o.omega,t.frequencyUnit)}</option>`:Ue}
          ${a.map(p=>ae`<option value="steady ${p.motion}" ?selected=${l===`steady ${p.motion}`}>${p.words}</option>`)}
          <option value="rest" ?selected=${l==="rest"}>at rest</option>
        </select>
      </div>
      <div class="bar">
        <span class="views" role="group" aria-label="View">${f.map(p=>ae`<button @click=${()=>this.stage?.look(p)}>${p}</button>`)}</span>
        <button title="Save the picture as PNG" @click=${this.savePicture}>PNG</button>
        <button title=${ym()?"Save a video of exactly one period (WebM)":"This browser cannot encode videos (WebCodecs)"} ?disabled=${!ym()||!this.motion||this.recording}
          @click=${this.saveVideo}>Video</button>
        <label><input type="checkbox" .checked=${t.damped} @change=${p=>{t.set({damped:p.target.checked}),n.again()}}> damped</label>
        <label><input type="checkbox" .checked=${t.traces} @change=${p=>t.set({traces:p.target.checked})}> trace</label>
      </div>
      <div class="bar">
        ${this.slider("Size",.01,.2,.005,t.share,p=>t.set({share:p}))}
        ${this.slider("Speed",.1,2,.1,t.speed,p=>t.set({speed:p}))}
        ${this.slider("Phase",0,360,1,t.phase*180/Math.PI,p=>t.set({phase:p*Math.PI/180,playing:!1}))}
      </div>
      <div class="bar">
        <label class="chosen">against <select aria-label="Motion against" @change=${p=>t.set({ghost:p.target.value})}>
          ${Object.entries(lv).map(([p,_])=>ae`<option value=${p} ?selected=${p===t.ghost}>${_}</option>`)}</select></label>
        <label class="chosen">mounts <select aria-label="Colour of mounts" @change=${p=>t.set({colouring:p.target.value})}>
          ${Object.entries(Kp).map(([p,_])=>ae`<option value=${p} ?selected=${p===t.colouring}>${_}</option>`)}</select></label>
      </div>`}label(){let{display:{shown:t,frequencyUnit:n,share:s},asker:r}=this.app,{motion:o}=this;if(!o)return t.kind==="steady"?Pv(r,t.omega):"at rest";let a=`${o.label}, ${es(o.angular_frequency,n)}${o.words?`: ${o.words}`:""}`,l=this.machine?ov(o,this.machine.scene.bodies,this.machine.scaleFor(o,s)):"";return l?`${a} · ${l}`:a}firstUpdated(){let t=this.querySelector("canvas");this.stage=new ed(t,(this.app.display.theme==="dark"?qu:$u).background,()=>this.frame()),this.watcher=new ResizeObserver(()=>this.stage.resize(t.clientWidth,t.clientHeight)),this.watcher.observe(t.parentElement),this.stage.resize(t.clientWidth,t.clientHeight),this.updated()}updated(){let{asker:t,display:n}=this.app,s=t.result("scene");if(!this.stage||!s)return;let r=n.theme==="dark"?qu:$u;if(s!==this.drawn.scene||!this.drawn.key.startsWith(n.theme)){let a=n.theme+JSON.stringify(s);a!==this.drawn.key&&(this.machine=new Ju(s,r),this.stage.show(this.machine,r,this.fitted!==s.title),this.fitted=s.title,this.traced=this.marked=[]),this.drawn={scene:s,key:a}}let o=this.motion;this.motion=this.shownMotion.of(this.app),this.draw(),o!==this.motion&&this.requestUpdate()}disconnectedCallback(){super.disconnectedCallback(),this.watcher?.disconnect(),this.stage?.dispose()}screw(){let{asker:t,display:{shown:n,damped:s},state:{selection:r}}=this.app,o=t.result("modes"),a=r?.kind==="body"?this.machine?.scene.bodies.find(c=>c.name===r.name):void 0,l=o&&a&&n.kind==="mode"&&!s?Cv(o,n.number,a):null;return l&&a?[l,a]:[null,null]}markScrew(){let{asker:t,display:{shown:n,damped:s},state:{selection:r}}=this.app,o=[t.result("modes"),n,s,r];if(o.every((c,h)=>c===this.marked[h])&&this.marked.length)return;this.marked=o;let[a,l]=this.screw();this.machine.showScrew(a,l)}draw(){let{asker:t,display:{playing:n,phase:s,traces:r,ghost:o,share:a,damped:l,shown:c,colouring:h},state:u}=this.app,d=this.stage,f=[this.machine,n,s,r,o,a,l,c,h,u.selection,u.case],p=[this.motion,...h==="none"?[]:["verdict","check","modes"].map(y=>t.result(y))],_=(y,T)=>y.length!==T.length||y.some((b,C)=>b!==T[C]),m=_(f,this.pictured.hand),g=d.isBehind||_(p,this.pictured.numbers);this.pictured={hand:f,numbers:p},m||g&&!this.numbersMove?d.draw():g&&d.drawWhenFree(dm)}get numbersMove(){return this.app.asker.isOld("curves")&&!this.app.asker.problems.some(t=>t.severity==="error")}mountValues(){let{asker:t,display:{colouring:n,shown:s},state:r}=this.app,o={verdict:t.result("verdict"),check:t.result("check"),modes:t.result("modes")};return Xx(n,o,r.case,s.kind==="mode"?s.number:null)}legend(){let{asker:t,display:{colouring:n}}=this.app,s=jR[n],r=s&&!t.result(s)&&(s!=="verdict"||vi(this.app));return Jx(n,this.mountValues(),s!==void 0&&t.isOld(s),r?t.missing(s):"")}frame(){if(!this.machine)return;let{display:t,state:n}=this.app,s=performance.now(),r=Math.min((s-this.last)/1e3,.1);this.last=s,t.playing&&this.motion&&(t.phase=(t.phase+2*Math.PI*t.speed*r)%(2*Math.PI),this.stage.drawWhenFree(this.numbersMove?dm:fm)),this.size(),this.trace(),this.machine.highlight(n.selection),this.markScrew(),this.machine.colour(this.mountValues()),this.machine.move(this.motion,t.phase,this.scale)}size(){let{share:t}=this.app.display,n=[this.machine,this.motion,t];n.every((s,r)=>s===this.sized[r])||(this.sized=n,this.scale=this.motion?this.machine.scaleFor(this.motion,t):0)}trace(){let{traces:t,ghost:n}=this.app.display,s=[t,n,this.motion,this.scale];s.every((r,o)=>r===this.traced[o])||(this.traced=s,this.machine.showTraces(t?this.motion:null,this.scale),this.machine.showGhosts(n,this.motion,this.scale))}slider(t,n,s,r,o,a){return ae`<label class="small">${t}<input type="range" min=${n} max=${s} step=${r} .value=${String(o)}
                  @input=${l=>a(Number(l.target.value))}></label>`}choose(t){let{value:n}=t.target,{display:s,asker:r}=this.app,{shown:o}=s;if(n==="frequency")"omega"in o&&s.set({shown:{kind:"frequency",omega:o.omega}});else if(n.startsWith("steady")){let{omega:a,motion:l}=mm(r.result("steady"),s)[Number(n.split(" ")[1])];s.set({shown:{kind:"steady",omega:a,motion:l},cursor:a})}else return s.set({shown:n==="rest"?{kind:"rest"}:{kind:"mode",number:Number(n)}});r.again()}pressed(t){this.down=[t.clientX,t.clientY]}released(t){Math.hypot(t.clientX-this.down[0],t.clientY-this.down[1])<4&&this.app.state.select(this.under(t))}moved(t){if(t.buttons)return;let n=this.under(t)?.name??"";n!==this.hovered&&(this.hovered=n,this.requestUpdate())}under(t){let{left:n,top:s,width:r,height:o}=t.currentTarget.getBoundingClientRect();return this.stage.pick(2*(t.clientX-n)/r-1,1-2*(t.clientY-s)/o)}savePicture(){let{state:t,display:n,asker:s}=this.app,r=s.result("scene")?.title??"",o=t.case?`case ${t.case}`:"";this.stage.drawNow();let a=this.querySelector("canvas"),l=[[r,o].filter(Boolean).join(" · "),this.label()].filter(Boolean);cv(a,l,n.theme==="dark"?qu:$u,a.width/a.clientWidth).toBlob(c=>Qp("machine.png",c))}async saveVideo(){let{display:t}=this.app,{phase:n,playing:s}=t,r=1/t.speed,{motion:o}=this;this.recording=!0,t.set({playing:!1});try{let a=await Dv(this.querySelector("canvas"),r,l=>{if(this.motion!==o)throw new Error("the motion was changed meanwhile.");t.phase=2*Math.PI*l,this.stage.drawNow()});Qp("machine.webm",new Blob([a],{type:"video/webm"})),t.set({notice:`machine.webm: one period in ${_m(r).count} frames.`})}catch(a){t.set({notice:`No video: ${a instanceof Error?a.message:String(a)}`})}this.recording=!1,t.set({phase:n,playing:s})}},jR={limit:"verdict",utilisation:"check",deflection:"check",compression:"check",energy:"modes"};me.define("machine-view",xm);var vm=class extends vn{render(){let{asker:e,file:t}=this.app,n=e.problems.filter(r=>r.severity==="error"),s=e.problems.length-n.length;return t?.trouble?.kind==="away"?Ue:e.trouble?ae`<div class="problems error" role="alert"><p>${e.trouble}</p><button @click=${()=>e.again()}>Try again</button></div>`:e.problems.length?ae`<details class="problems ${n.length?"error":"warning"}" ?open=${n.length>0}>
      <summary>${n.length?`${n.length} ${n.length===1?"error":"errors"}`:""}${n.length&&s?", ":""}${s?`${s} ${s===1?"warning":"warnings"}`:""}</summary>
      <ul>${e.problems.map(r=>ae`<li class=${r.severity}><button class="link" ?disabled=${!r.line||!this.closest("page-shell")} @click=${()=>this.go(r.line??0)}>${r.line?`line ${r.line}: `:""}${r.message}</button></li>`)}</ul></details>`:Ue}async go(e){this.app.display.set({leftTab:"text"}),await new Promise(requestAnimationFrame),document.querySelector("text-view")?.show(e)}};me.define("problem-list",vm);var bm=1e3,Sm=class extends vn{render(){let{state:e,display:t}=this.app,n=oc(e.design,this.app.index,t.pins,e.case);return ae`<ul class="sliders">${n.map(s=>this.row(s))}</ul>
      ${n.length?Ue:ae`<p class="hint">The file has no number that a slider could move. Add [parameters], or pin a number in the model.</p>`}
      <p class="hint">${t.pins.length?Ue:"More sliders: ⊕ beside a number of the model, or [parameters] in the file."}</p>`}row(e){let t=JR(e,e.value),n=e.paths.some(r=>this.app.state.design.settings.has(r.path)),s=this.app.display.pins.includes(e.name);return ae`<li class=${n?"changed":""}>
      <label title=${e.paths.map(r=>r.path).join(`
`)}><span>${e.name}</span>
        <input type="range" min="0" max=${bm} .value=${String(t)} aria-valuetext="${je(e.value)} ${e.unit}"
          @input=${r=>this.move(e,r.target.value,!0)} @change=${()=>this.app.state.dropped()}></label>
      <input class="number" aria-label="${e.name}, value" .value=${Uv(e)}
        @change=${r=>this.type(e,r.target)}>
      ${e.paths.some(r=>r.path.startsWith("cases."))&&!e.name.startsWith("cases.")?ae`<small class="hint">of case ${this.app.state.case}</small>`:Ue}
      ${s?ae`<button title="Remove the slider" @click=${()=>this.app.display.set({pins:this.app.display.pins.filter(r=>r!==e.name)})}>×</button>`:Ue}
    </li>`}move(e,t,n){let s=Number(t)/bm,r=e.logarithmic?e.from*(e.to/e.from)**s:e.from+s*(e.to-e.from);this.app.state.set(fa(e,r),n)}type(e,t){let n=kn(t.value.replaceAll("−","-").replace(",","."));if(!n)return uc(t,this.app,Uv(e));this.app.state.set(fa({...e,unit:n.unit||e.unit},n.value))}},Uv=({value:i,unit:e})=>`${je(i,5)}${e?` ${e}`:""}`;function JR({from:i,to:e,logarithmic:t},n){let s=t?Math.log(n/i)/Math.log(e/i):(n-i)/(e-i);return Math.round(bm*Math.min(Math.max(s||0,0),1))}me.define("slider-panel",Sm);function Ov({state:i,cases:e}){return e.length>1?ae`<select aria-label="Case" @change=${t=>i.chooseCase(t.target.value)}>
      ${e.map(t=>ae`<option value=${t} .selected=${t===i.case}>${t||"base model"}</option>`)}</select>`:Ue}var KR={met:"✓",violated:"✗",unbinding:"(✗)",none:"○",error:"!",unknown:"…"};function Fv(i){let e=Qm(i);return ae`<span class="pill ${e.state}" role="status">${KR[e.state]} ${e.words}${e.old?" …":""}</span>`}var Pl=class extends vn{static{this.properties={...vn.properties,times:{state:!0}}}constructor(){super(),this.times=0}connectedCallback(){super.connectedCallback(),this.times++}render(){let{app:e}=this,{state:t,asker:n,project:s,display:r,engine:o}=e,a=n.result("scene")?.title||s.title||"",l=this.getRootNode();return l instanceof ShadowRoot&&(l.host.dataset.theme=r.theme),ae`<header>
        <span class="title" title=${a}>${a}</span>
        ${o.isLive?Ov(e):t.case?ae`<span>${t.case}</span>`:Ue}
        ${Fv(e)}<span class="space"></span>
        ${o.isLive?ae`<button title="Undo" aria-label="Undo" ?disabled=${!t.canUndo} @click=${()=>t.undo()}>↶</button>
          <button title="Redo" aria-label="Redo" ?disabled=${!t.canRedo} @click=${()=>t.redo()}>↷</button>`:ae`<span class="note">as it was last computed</span>`}
      </header>
      <problem-list .app=${e}></problem-list>
      ${o.isLive?ae`<section aria-label="Sliders"><slider-panel .app=${e}></slider-panel></section>`:Ue}
      ${Zg(this.times,ae`<main>
        <section class="middle" aria-label="Machine"><machine-view .app=${e}></machine-view></section>
        <section class="right" aria-label="Results"><curve-chart .app=${e}></curve-chart><result-tables .app=${e}></result-tables></section>
      </main>`)}`}};me.define("notebook-view",Pl);function kv(){let{dataset:i,classList:e}=document.body;return i.jpThemeLight!==void 0?i.jpThemeLight==="true"?"light":"dark":e.contains("vscode-light")||e.contains("vscode-high-contrast-light")?"light":e.contains("vscode-dark")||e.contains("vscode-high-contrast")||matchMedia("(prefers-color-scheme: dark)").matches?"dark":"light"}function Mm({display:i}){let e=()=>{i.theme!==kv()&&i.set({theme:kv()})},t=new MutationObserver(e);return t.observe(document.body,{attributes:!0,attributeFilter:["data-jp-theme-light","class"]}),e(),()=>t.disconnect()}var Bv=["shown","damped","share","speed","frequencyUnit","logarithmicFrequency","logarithmicAmplitude","decibel"];var zv=({display:i,asker:e},t)=>{i.set(Object.fromEntries(Bv.filter(n=>n in t).map(n=>[n,t[n]]))),e.again()};function Vv(i,e,t){let{state:n,display:s,asker:r}=i,o=0,a="",l=[],c=()=>{let d=r.finished;if(!d)return;let f=Object.fromEntries(Bv.map(_=>[_,s[_]])),p=[n.revision,JSON.stringify(f),...d.results.map(_=>_.json)];p.length===l.length&&p.every((_,m)=>_===l[m])||(e.keep(f,d),l=p)},h=()=>{let{settings:d,case:f}=n.change,p=JSON.stringify([d,f]);p!==a&&(t.set("_settings",d),t.set("_case",f),t.save_changes(),a=p),clearTimeout(o),o=window.setTimeout(c,500)},u=[n.subscribe(h),s.subscribe(h),r.subscribe(h),()=>{clearTimeout(o)}];return h(),()=>{for(let d of u)d()}}var wm="data-trivet-still",QR=globalThis,eP=()=>(QR.trivetWidgetBuild??="b78b81e772506d64")==="b78b81e772506d64";function tP({model:i,el:e}){let t=new Ol(i),n=[()=>t.close()],s=!1;return t.opened().then(r=>{if(s)return;nP(r.key);let o=Gv(e,t,r);o&&n.push(Mm(o),Vv(o,t,i))},r=>{e.textContent=r instanceof Error?r.message:String(r)}),()=>{s=!0;for(let r of n)r()}}function Gv(i,e,t){if(!eP())return i.textContent="This page already has the widget of another build of Trivet. Reload the page.",null;let n=document.createElement("div"),s=n.attachShadow({mode:"open"}),r=new CSSStyleSheet;r.replaceSync(`.uplot,.uplot *,.uplot *:before,.uplot *:after{box-sizing:border-box}.uplot{font-family:system-ui,-apple-system,Segoe UI,Roboto,Helvetica Neue,Arial,Noto Sans,sans-serif,"Apple Color Emoji","Segoe UI Emoji",Segoe UI Symbol,"Noto Color Emoji";line-height:1.5;width:min-content}.u-title{text-align:center;font-size:18px;font-weight:700}.u-wrap{position:relative;user-select:none}.u-over,.u-under{position:absolute}.u-under{overflow:hidden}.uplot canvas{display:block;position:relative;width:100%;height:100%}.u-axis{position:absolute}.u-legend{font-size:14px;margin:auto;text-align:center}.u-inline{display:block}.u-inline *{display:inline-block}.u-inline tr{margin-right:16px}.u-legend th{font-weight:600}.u-legend th>*{vertical-align:middle;display:inline-block}.u-legend .u-marker{width:1em;height:1em;margin-right:4px;background-clip:padding-box!important}.u-inline.u-live th:after{content:":";vertical-align:middle}.u-inline:not(.u-live) .u-value{display:none}.u-series>*{padding:4px}.u-series th{cursor:pointer}.u-legend .u-off>*{opacity:.3}.u-select{background:#00000012;position:absolute;pointer-events:none}.u-cursor-x,.u-cursor-y{position:absolute;left:0;top:0;pointer-events:none;will-change:transform}.u-hz .u-cursor-x,.u-vt .u-cursor-y{height:100%;border-right:1px dashed #607D8B}.u-hz .u-cursor-y,.u-vt .u-cursor-x{width:100%;border-bottom:1px dashed #607D8B}.u-cursor-pt{position:absolute;top:0;left:0;border-radius:50%;border:0 solid;pointer-events:none;will-change:transform;background-clip:padding-box!important}.u-axis.u-off,.u-select.u-off,.u-cursor-x.u-off,.u-cursor-y.u-off,.u-cursor-pt.u-off{display:none}:root,:host{color-scheme:light;--back: #ffffff;--panel: #f4f6f8;--line: #d3dae0;--text: #1d2a33;--soft: #50616c;--accent: #00659c;--accent-text: #ffffff;--good: #1c6b2f;--good-back: #dff2e3;--bad: #a81313;--bad-back: #fde4e1;--warn: #7a4b00;--warn-back: #fff0d6;--chosen: #dcebf5}:root[data-theme=dark],:host([data-theme="dark"]){color-scheme:dark;--back: #14191d;--panel: #1b2227;--line: #38444d;--text: #e3ebf0;--soft: #a3b3be;--accent: #7cc7f2;--accent-text: #0c1216;--good: #8fe0a3;--good-back: #17361f;--bad: #ffa79a;--bad-back: #451c18;--warn: #ffc56b;--warn-back: #3d2e12;--chosen: #23404f}*{box-sizing:border-box}html,body{height:100%;margin:0}body,notebook-view{background:var(--back);color:var(--text);font:13px/1.35 system-ui,DejaVu Sans,sans-serif}body{overflow:hidden}page-shell{display:flex;flex-direction:column;height:100%}h1,h2{font-size:13px;font-weight:650;margin:0}button,select,input{font:inherit;color:inherit}button,select{background:var(--back);border:1px solid var(--line);border-radius:4px;padding:2px 8px;min-height:26px}button{cursor:pointer}button:hover:not(:disabled){border-color:var(--accent)}button:disabled{opacity:.45;cursor:default}button.link{background:none;border:0;padding:0;min-height:0;text-align:left}button.link:hover:not(:disabled){text-decoration:underline}button.link:disabled{opacity:1}:focus-visible{outline:2px solid var(--accent);outline-offset:1px}input[type=range]{accent-color:var(--accent)}input[type=checkbox]{accent-color:var(--accent);margin:0;vertical-align:-2px}.hidden{position:absolute;width:1px;height:1px;overflow:hidden;clip-path:inset(50%);white-space:nowrap;margin:0}.space{flex:1}.old{color:var(--warn);font-weight:700}.hint{color:var(--soft);margin:6px 0}.missing{position:absolute;inset:40% 10% auto;text-align:center;color:var(--soft);white-space:pre-line}.fatal{margin:20vh auto;max-width:36em;font-size:16px}header{display:flex;align-items:center;gap:8px;padding:5px 10px;border-bottom:1px solid var(--line);min-height:40px}header h1{color:var(--accent);font-size:15px}header .title{font-weight:600;overflow:hidden;text-overflow:ellipsis;white-space:nowrap;max-width:30em}.pill{border-radius:12px;padding:3px 12px;font-weight:650;white-space:nowrap;background:var(--panel)}.pill.met{background:var(--good-back);color:var(--good)}.pill.violated,.pill.error{background:var(--bad-back);color:var(--bad)}.pill.unbinding{background:var(--warn-back);color:var(--warn)}.pill.none,.pill.unknown{color:var(--soft)}case-bar,case-bar form{display:flex;gap:4px;flex:none}progress-line{min-width:0;overflow:hidden;text-overflow:ellipsis;white-space:nowrap;color:var(--soft)}.unsaved{background:var(--accent);color:var(--accent-text);border-color:var(--accent)}.problems{padding:4px 10px;border-bottom:1px solid var(--line);max-height:30vh;overflow:auto}.problems p{margin:4px 0}.problems ul{margin:4px 0;padding-left:18px}.problems.error,.problems .error{color:var(--bad)}.problems.warning,.problems .warning{color:var(--warn)}.toast{position:fixed;bottom:12px;left:50%;transform:translate(-50%);background:var(--text);color:var(--back);padding:6px 14px;border-radius:5px;margin:0;z-index:20}.toast[hidden]{display:none}main{flex:1;min-height:0;display:grid;grid-template-columns:262px minmax(320px,1fr) minmax(400px,36%)}main.tab-text{grid-template-columns:minmax(380px,34%) minmax(300px,1fr) minmax(380px,33%)}main>section{min-width:0;min-height:0;display:flex;flex-direction:column}main>section+section{border-left:1px solid var(--line)}.scroll{overflow:auto;min-height:0}.tabs{display:flex;gap:2px;padding:5px 8px 0;border-bottom:1px solid var(--line);flex:none}.tabs button{border-radius:4px 4px 0 0;border-color:transparent;border-bottom:0;color:var(--soft);background:none}.tabs button[aria-selected=true]{color:var(--text);border-color:var(--line);background:var(--panel);font-weight:650}.panel{flex:1;padding:8px;background:var(--panel)}.tab-text .panel{padding:0}text-view{display:block;height:100%}.sliders{list-style:none;margin:0;padding:0}.sliders li{display:grid;grid-template-columns:1fr auto auto;gap:0 6px;padding:5px 0 7px;align-items:end}.sliders label{grid-column:1 / -1;display:flex;flex-direction:column}.sliders label span{padding-right:104px;overflow-wrap:anywhere;min-height:22px}.sliders li{position:relative}.sliders .number{position:absolute;top:2px;right:0;width:98px;text-align:right}.sliders button{position:absolute;top:2px;right:102px;min-height:22px;padding:0 6px}.sliders .changed span{font-weight:650;color:var(--accent)}.sliders input[type=range]{width:100%;margin:5px 0 0;height:18px}.number{background:var(--back);border:1px solid var(--line);border-radius:3px;padding:1px 5px;min-width:0;font-variant-numeric:tabular-nums}.number.changed{border-color:var(--accent);font-weight:650}.tree,.tree ul{list-style:none;margin:0;padding:0}.tree ul{padding-left:13px}.tree li:not(:has(>details)){display:flex;gap:6px;align-items:center;padding:1px 0}.tree .key{flex:none;color:var(--soft);max-width:11em;overflow:hidden;text-overflow:ellipsis;white-space:nowrap}.tree .value{overflow:hidden;text-overflow:ellipsis;white-space:nowrap}.tree .number{flex:1;width:4em}.tree .vector{display:flex;gap:3px;flex:1;min-width:0}.tree .pin{border:0;background:none;padding:0 2px;min-height:20px;color:var(--accent)}.tree summary{cursor:pointer;padding:1px 3px;border-radius:3px}.tree summary.chosen{background:var(--chosen);font-weight:650}machine-view{flex:1;display:flex;flex-direction:column;min-height:0}.stage{flex:1;position:relative;min-height:120px;background:var(--panel)}.stage canvas{position:absolute;inset:0;width:100%;height:100%;touch-action:none}.caption,.hover{position:absolute;left:10px;pointer-events:none;text-shadow:0 0 4px var(--panel),0 0 4px var(--panel)}.caption{top:8px;font-weight:650;right:10px}.hover{bottom:8px;color:var(--soft)}.legend{position:absolute;left:10px;bottom:28px;width:196px;display:flex;flex-direction:column;gap:1px;pointer-events:none;padding:5px 8px;border-radius:4px;background:color-mix(in srgb,var(--panel) 85%,transparent);font-size:12px}.legend svg{width:100%;height:11px}.legend .ticks{display:flex;justify-content:space-between;font-variant-numeric:tabular-nums}.legend .ticks.limited{display:grid;grid-template-columns:1fr auto 14.7%}.legend .ticks.limited span:last-child{text-align:right}.bar{display:flex;align-items:center;gap:4px 7px;flex-wrap:wrap;padding:4px 8px}.bar label{white-space:nowrap}.bar .small{display:flex;align-items:center;gap:4px;flex:1 1 70px}.bar .small input{width:100%;min-width:50px}.bar>select{flex:0 1 auto;min-width:0}machine-view .bar>select{flex:1}.bar .chosen{display:flex;align-items:center;gap:4px;flex:1 1 120px;min-width:0}.bar .chosen select{flex:1;min-width:40px}.views{display:flex}.views button{border-radius:0;margin-left:-1px;padding:2px 6px}.play{width:34px}main>.right{overflow-y:auto}curve-chart{flex:1 0 60%;display:flex;flex-direction:column;position:relative}curve-chart .bar{padding-bottom:0;gap:4px 6px;font-size:12px}.plots{flex:1 0 340px;display:flex;flex-direction:column;min-height:340px;position:relative}.plots>.amplitude{flex:3;min-height:0}.plots>.phase{flex:1.2;min-height:108px}.u-over{cursor:crosshair}.u-select{background:color-mix(in srgb,var(--accent) 22%,transparent)}.u-cursor-x{display:none}curve-chart .bar select{padding:2px 3px}curve-chart .bar select[aria-label=Quantity]{max-width:122px}curve-chart .bar select[aria-label="Unit of frequency"]{width:56px}.menu{position:relative}.menu summary{cursor:pointer;border:1px solid var(--line);border-radius:4px;padding:3px 8px;list-style:none}.menu>div{position:absolute;right:0;z-index:10;display:flex;flex-direction:column;gap:4px;padding:8px;background:var(--back);border:1px solid var(--line);border-radius:4px;box-shadow:0 2px 8px #0004;max-height:240px;overflow:auto}.readings span.curve svg{width:26px}.amplitude{position:relative}.limits{position:absolute;pointer-events:none;z-index:3}.limit{position:absolute;pointer-events:auto;cursor:ns-resize;touch-action:none;border-radius:3px}.limit.fixed{cursor:help}.limit:hover:not(.fixed),.limit:focus-visible{background:color-mix(in srgb,var(--accent) 25%,transparent)}.limit span{position:absolute;font-variant-numeric:tabular-nums;padding:0 3px 0 8px;color:var(--text);background:repeating-linear-gradient(var(--stroke) 0 var(--on),transparent var(--on) var(--period)) left / 3px 100% no-repeat color-mix(in srgb,var(--back) 78%,transparent);font-size:11px;line-height:14px;white-space:nowrap}.limit span.unseen{display:none}.limit:is(:hover,:focus-visible){z-index:1}.limit:is(:hover,:focus-visible) span{display:block;background-color:var(--back)}.limit.violated span{color:var(--bad);font-weight:650}.limit.unbinding span{color:var(--warn)}.readings{display:flex;flex-wrap:wrap;gap:1px 4px;padding:2px 8px;max-height:230px;overflow:auto;flex:none;font-variant-numeric:tabular-nums;border-top:1px solid var(--line)}.readings .cursor{min-width:5.5em;font-weight:650}.readings .curve{border:0;min-height:20px;padding:0 3px;background:none}.readings .curve[aria-pressed=false]{opacity:.55;text-decoration:line-through}.note{color:var(--soft)}.readings details>ul{position:absolute;left:8px;right:8px;z-index:10;margin:2px 0;padding:8px 8px 8px 24px;background:var(--back);border:1px solid var(--line);border-radius:4px;box-shadow:0 2px 8px #0004;max-height:50vh;overflow:auto}.readings svg{width:18px;height:6px;vertical-align:middle}curve-chart>.table{flex:0 0 auto;max-height:220px;border-top:1px solid var(--line)}result-tables{flex:1 1 40%;display:flex;flex-direction:column;min-height:190px;border-top:1px solid var(--line)}.table{flex:1;padding:2px 8px}table{border-collapse:collapse;width:100%;font-variant-numeric:tabular-nums}caption{text-align:left;color:var(--soft)}th,td{padding:2px 6px;text-align:right;white-space:nowrap;border-bottom:1px solid var(--line)}thead th{position:sticky;top:0;background:var(--back);color:var(--soft);font-weight:600}tbody th{font-weight:500}th:first-child,.words{text-align:left}.words{white-space:normal}tbody tr:hover,tr.chosen{background:var(--chosen)}tr.violated{color:var(--bad)}tr.unbinding,.minor{color:var(--warn)}.bad{color:var(--bad);font-weight:650}td .number{width:114px;text-align:right}.requirements :is(th,td){padding:2px 4px}.requirements{table-layout:fixed}.requirements td{white-space:normal;overflow-wrap:anywhere}.requirements .value{width:124px}.requirements .margin{width:60px}.requirements .elsewhere{width:82px}.requirements .met{width:32px}.requirements .number{display:block;margin-left:auto}tr.unjudged{color:var(--soft)}.share.coupled{text-decoration:underline dotted;cursor:help}.share{padding:2px 3px}map-panel{display:flex;flex-direction:column;min-height:100%}map-panel .bar{padding:0 0 2px}.map{position:relative;flex:1 0 200px;min-height:200px;touch-action:none;cursor:crosshair}.map canvas{position:absolute;inset:0;width:100%;height:100%}.design{position:absolute;width:16px;height:16px;margin:-8px 0 0 -8px;border:3px solid var(--accent);border-radius:50%;background:var(--back);box-shadow:0 0 0 2px var(--back);cursor:move;pointer-events:none}map-panel .hint{margin:2px 0}.rules{list-style:none;margin:0;padding:0;display:flex;flex-wrap:wrap;gap:0 10px;font-size:12px}.rules svg{width:10px;height:10px;margin-right:4px}main.empty{display:block;padding:8vh 10vw;overflow:auto;font-size:15px}main.empty h2{font-size:24px}.examples{list-style:none;padding:0;display:grid;grid-template-columns:repeat(3,1fr);gap:14px}.examples button{width:100%;height:100%;padding:18px;text-align:left;display:flex;flex-direction:column;gap:8px}.examples b{font-size:16px}.examples span{color:var(--soft)}@media(max-width:980px){body{overflow:auto}page-shell{height:auto}main,main.tab-text{grid-template-columns:1fr}main>section+section{border-left:0;border-top:1px solid var(--line)}.stage{min-height:320px}.plots{height:380px;flex:none}header{flex-wrap:wrap}header .title{max-width:100%}}@media(max-width:600px){curve-chart .menu{position:static}curve-chart .menu>div{left:8px;right:auto;max-width:calc(100% - 16px)}}main.empty{padding:4vh 8vw}main.empty form{display:grid;grid-template-columns:repeat(5,minmax(0,1fr));gap:10px 14px;align-items:end;margin:10px 0 18px;font-size:13px}main.empty form label{display:flex;flex-direction:column;gap:3px}main.empty form :is(input,select){border:1px solid var(--line);border-radius:4px;background:var(--back);padding:4px 6px;min-width:0;width:100%;box-sizing:border-box}main.empty .wrong{color:var(--bad);grid-column:1 / -1;margin:0}.problems pre{margin:4px 0;max-height:16vh;overflow:auto;color:var(--text);user-select:all}.difference .first{color:var(--bad)}.difference .second{color:var(--good)}:host{display:block;container-type:inline-size;border:1px solid var(--line);border-radius:4px;overflow:hidden}notebook-view{display:flex;flex-direction:column;text-align:left;white-space:normal}notebook-view>section{padding:4px 10px 2px;background:var(--panel);border-bottom:1px solid var(--line);max-height:190px;overflow:auto}notebook-view .sliders{display:grid;grid-template-columns:repeat(auto-fill,minmax(230px,1fr));gap:0 18px}notebook-view slider-panel .hint{display:none}notebook-view>main{height:640px;flex:none;grid-template-columns:minmax(0,1fr) minmax(0,1.05fr)}notebook-view .stage{min-height:120px}notebook-view .plots{height:auto;flex:1 0 240px;min-height:240px}notebook-view curve-chart{flex:1 1 auto}notebook-view result-tables{flex:0 0 215px}@container (max-width: 760px){notebook-view>main{height:auto;grid-template-columns:1fr}notebook-view>main>section+section{border-left:0;border-top:1px solid var(--line)}notebook-view .stage{min-height:320px}notebook-view curve-chart{flex:none}notebook-view .plots{height:380px;flex:none}}
`),s.adoptedStyleSheets=[r],n.dataset.lmSuppressShortcuts="true",n.addEventListener("keydown",l=>l.stopPropagation());let o=new Pl,a=qg(e,t);return o.app=a,a.display.pins=t.sliders,a.state.open(t.text,"",t.settings,t.case),s.append(o),i.replaceChildren(n),a}function nP(i){for(let t of document.querySelectorAll(`[${wm}="${i}"]`))t.replaceChildren();let e=document.createElement("style");e.textContent=`[${wm}="${i}"] { display: none; }`,document.head.append(e)}async function YF(){for(let i of document.querySelectorAll(`[${wm}][data-kept]`)){if(getComputedStyle(i).display==="none")continue;let e=JSON.parse(await iP(i.dataset.kept));delete i.dataset.kept;let t=Gv(i,new kl(e),e.opened);t&&zv(t,e.view),t&&Mm(t)}}async function iP(i){let e=Uint8Array.from(atob(i),t=>t.charCodeAt(0));return new Response(new Blob([e]).stream().pipeThrough(new DecompressionStream("gzip"))).text()}var ZF={render:tP};export{ZF as default,YF as showStills};
