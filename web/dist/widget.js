var ue={define(i,e){globalThis.customElements.get(i)||globalThis.customElements.define(i,e)}};function lg(i){return new Hl(i).file()}function*Td(i){for(let e of i)yield e,yield*Td(e.children)}var Oi=i=>i.map(e=>/^[\w-]+$/.test(e)?e:`"${e.replace(/["\\]/g,"\\$&")}"`).join(".");function yr(i){return new Hl(i).key()}var Hl=class{constructor(e){this.text=e;this.at=0}file(){let e=[],t=null;for(;this.at<this.text.length;){this.skipBlank();let n=this.at;if(this.text[this.at]==="[")t=this.header(n),e.push(t);else if(this.at<this.text.length){let s=this.pair(t?.path??[]);s&&(t?t.children:e).push(s),t&&(t.to=this.at)}this.skipLine(),this.at===n&&this.at++}return e}key(){let e=[];for(;;){this.skipSpaces();let t=this.text[this.at];if(t==='"'||t==="'")e.push(this.quoted());else{let n=this.match(/[\w\-]+/y);if(!n)break;e.push(n)}if(this.skipSpaces(),this.text[this.at]!==".")break;this.at++}return e}header(e){this.match(/\[+/y);let t=this.key();return this.match(/\s*\]+/y),{path:t,from:this.at,to:this.at,keyFrom:e,kind:"table",raw:"",children:[]}}pair(e){let t=this.at,n=this.key();return this.skipSpaces(),!n.length||this.text[this.at]!=="="?null:(this.at++,this.skipSpaces(),this.value([...e,...n],t))}value(e,t){let n=this.at,s=this.text[n],r="other",o=[];if(s==="[")[r,o]=["array",this.array(e)];else if(s==="{")[r,o]=["table",this.inlineTable(e)];else if(s==='"'||s==="'"){let a=this.quoted();r=/^\s*[-+]?(\d|\.\d)/.test(a)&&!/^\d+[\w-]*:/.test(a)?"number":"text"}else{let a=this.match(/[^\s,\]}#]+/y)??"";r=/^[-+]?(\d|\.\d|inf|nan)/.test(a)?"number":"other"}return{path:e,from:n,to:this.at,keyFrom:t,kind:r,raw:this.text.slice(n,this.at),children:o}}array(e){let t=[];for(this.at++;this.skipBlank(),!(this.at>=this.text.length||this.text[this.at]==="]");){let n=this.at;if(t.push(this.value([...e,String(t.length)],this.at)),this.skipBlank(),this.text[this.at]===","&&this.at++,this.at===n)break}return this.at++,t}inlineTable(e){let t=[];for(this.at++;this.skipBlank(),!(this.at>=this.text.length||this.text[this.at]==="}");){let n=this.pair(e);if(!n)break;t.push(n),this.skipBlank(),this.text[this.at]===","&&this.at++}return this.at++,t}quoted(){let e=this.text[this.at],t=e.repeat(3);if(this.text.startsWith(t,this.at)){let r=this.text.indexOf(t,this.at+3),o=this.at+3;return this.at=r<0?this.text.length:r+3,this.text.slice(o,r<0?void 0:r)}let s=this.match(e==='"'?/"(?:[^"\\\n]|\\.)*"?/y:/'[^'\n]*'?/y).replace(/^["']|["']$/g,"");return e==='"'?s.replace(/\\(["\\])/g,"$1"):s}skipSpaces(){this.match(/[ \t]*/y)}skipBlank(){this.match(/(?:\s|#[^\n]*)*/y)}skipLine(){this.match(/[^\n]*\n?/y)}match(e){e.lastIndex=this.at;let t=e.exec(this.text);return t?(this.at=e.lastIndex,t[0]):null}};var cg="--set ",fa=({file:i=""})=>i.startsWith(cg)?Oi(yr(i.slice(cg.length))):null;function hg(i,e,t){let n=fa(i);if(n===null)return i.line??0;let s=t.numbers.get(n)??t.byPath.get(yr(n).join("\0"));return s?e.slice(0,s.keyFrom).split(`
`).length:0}function Ad(i,e=i.line??0){let{file:t="",severity:n,message:s}=i,r=`${t}: ${n}: `,o=fa(i)!==null&&s.startsWith(r)?s.slice(r.length):s;return e?`line ${e}: ${o}`:o}var ug=(i,e)=>e.findIndex(t=>t.severity==="error"&&i.some(n=>n===fa(t)||n===t.subject)),pa=i=>`problem-${i}`;var dg=({rule:i,remedy:e,message:t})=>[i,e].filter(Boolean).join("; ")||t;var ci=class extends Error{constructor(t,n=!1,s=!1){super(t);this.isSilent=n;this.isListed=s}};var fg="The kernel has ended. Run the cell again.",Wl=()=>Promise.reject(new ci("A notebook edits and saves its project in Python.")),$l=class{constructor(e){this.model=e;this.isLive=!0;this.oneAtATime=!0;this.client=Math.random().toString(36).slice(2);this.waiting=new Map;this.count=0;this.ended=!1;this.opened=()=>this.send({ask:"open"});this.project=()=>this.opened();this.schema=Wl;this.text=Wl;this.newCase=Wl;this.save=Wl;this.receive=({id:e,error:t},[n])=>{let s=this.waiting.get(e);s&&(this.waiting.delete(e),t!==void 0||!n?s.failed(new ci(t??"The kernel sent no answer.")):s.done(new TextDecoder().decode(n)))};this.end=()=>{this.ended=!0;for(let{failed:e}of this.waiting.values())e(new ci(fg));this.waiting.clear()};e.on("msg:custom",this.receive),e.on("comm:close",this.end),e.on("comm_live_update",this.end)}ask(e,{settings:t,case:n},s,r){return this.send({ask:"answer",question:{revision:e,settings:t,case:n,wants:s}},r)}keep(e,t){this.model.send({ask:"keep",view:e,answer:t})}close(){this.model.off("msg:custom",this.receive),this.model.off("comm:close",this.end),this.model.off("comm_live_update",this.end)}send(e,t){if(this.ended)return Promise.reject(new ci(fg));if(t?.aborted)return Promise.reject(t.reason);let n=`${this.client} ${++this.count}`;return new Promise((s,r)=>{this.waiting.set(n,{done:o=>s(JSON.parse(o)),failed:r}),t?.addEventListener("abort",()=>{this.waiting.delete(n)&&r(t.reason)}),this.model.send({id:n,...e})})}};var ql=()=>Promise.reject(new ci("There is no kernel.")),Xl=class{constructor(e){this.kept=e;this.isLive=!1;this.project=async()=>this.kept.opened;this.schema=ql;this.text=ql;this.newCase=ql;this.save=ql}async ask(e,t,n){let{ok:s,problems:r,results:o}=this.kept.answer,a={ok:!1,problems:[],failure:"This result was not kept.",json:null};return{revision:e,ok:s,problems:r,results:n.map(({command:l})=>o.find(c=>c.command===l)??{command:l,...a})}}};var $b=["quick","exact","after","slow"],pg={quick:0,exact:70,after:70,slow:200},ma=i=>i.as??i.want.command,Cd=i=>`draft of ${i}`,mg=({want:i,settings:e})=>JSON.stringify([i,e]),qb=({exact:i,after:e,slow:t})=>t?"slow":e?"after":i?"exact":"quick",ga=class{constructor(e,t,n,s=1/0,r=0){this.engine=e;this.state=t;this.wishes=n;this.patience=s;this.idle=r;this.problems=[];this.trouble="";this.results=new Map;this.good=new Map;this.underWay=null;this.asked={quick:-1,exact:-1,after:-1,slow:-1};this.changedAt=0;this.seen=-1;this.idleUntil=0;this.listeners=new Set;this.isOld=e=>this.present(e)?.revision!==this.state.revision;this.revisionOf=e=>(this.shown(e)??this.present(e))?.revision??-1;t.subscribe(()=>this.next())}result(e){return this.shown(e)?.outcome.json??null}isOutdated(e){let t=this.shown(e);return t!==void 0&&t!==this.present(e)}get hasErrors(){return this.problems.some(e=>e.severity==="error")}notes(e){let t=this.results.get(e);return t?.generation===this.state.generation?t.outcome.notes??[]:[]}failure(e){let t=this.results.get(e);return!t||t.generation!==this.state.generation||t.outcome.ok?"":t.outcome.failure||t.outcome.problems.map(n=>n.message).join(`
`)}missing(e){return this.hasErrors?"The file has errors; see the messages above.":this.failure(e)||"Computing …"}get finished(){let e=this.wishes().filter(n=>n.as===void 0);if(this.underWay||!e.length||e.some(n=>this.results.get(ma(n))?.revision!==this.state.revision))return null;let t=e.map(n=>{let{hash:s,same:r,...o}=this.results.get(ma(n)).outcome;return o});return{revision:this.state.revision,ok:t.every(n=>n.ok),problems:this.problems,results:t}}again(){this.trouble="",this.asked={quick:-1,exact:-1,after:-1,slow:-1},this.next()}afresh(){for(let e of this.results.values())e.asked="";this.again()}subscribe(e){return this.listeners.add(e),()=>this.listeners.delete(e)}next(){let{revision:e}=this.state,t=performance.now();if(e!==this.seen&&([this.seen,this.changedAt]=[e,t]),clearTimeout(this.restTimer),this.underWay){let{pace:r,began:o,end:a,revision:l}=this.underWay,c=r==="quick"?o+this.patience-t:0;l!==e&&c<=0?a.abort():l!==e&&Number.isFinite(c)&&(this.restTimer=setTimeout(()=>this.next(),c));return}let n=$b.find(r=>this.asked[r]!==e);if(!n)return;let s=(n==="quick"?Math.min(this.idleUntil,this.changedAt+pg.slow):this.changedAt+pg[n])-t;s<=0?this.send(n,e):this.restTimer=setTimeout(()=>this.next(),s)}async send(e,t){let n=this.wishes().filter(o=>qb(o)===e&&!this.isKept(o)),{generation:s,change:r}=this.state;if(this.asked[e]=t,n.length){let{began:o,end:a}=this.underWay={pace:e,revision:t,began:performance.now(),end:new AbortController};try{let c=[...r.settings,...n.flatMap(h=>h.settings??[])];this.take(await this.engine.ask(t,{...r,settings:c},n.map(h=>this.unknown(h)),a.signal),n,s),this.trouble=""}catch(c){a.signal.aborted||(this.trouble=c instanceof ci?c.message:String(c))}this.underWay=null;let l=performance.now();if(e==="quick"&&(this.idleUntil=l+this.idle*(l-o)),!a.signal.aborted)for(let c of this.listeners)c()}(!this.trouble||this.state.revision!==t)&&this.next()}shown(e){let t=this.present(e);if(t?.outcome.ok)return t;let n=this.hasErrors?gg(e,this.good):void 0;return n?.file===this.state.file?n:void 0}present(e){let t=gg(e,this.results);return t?.generation===this.state.generation?t:void 0}isKept(e){let t=this.results.get(ma(e)),{revision:n,generation:s}=this.state;return t?.outcome.ok&&t.revision===n&&t.generation===s&&t.asked===mg(e)}unknown(e){let t=this.results.get(ma(e))?.outcome.hash;return t?{...e.want,known:t}:e.want}take(e,t,n){if(n===this.state.generation){this.problems=e.problems;for(let s of e.results){let r=t.find(h=>h.want.command===s.command),o=r?ma(r):s.command,a=this.results.get(o);if(a&&a.generation===n&&a.revision>e.revision)continue;let l=s.same&&a?a.outcome.json:s.json,c={revision:e.revision,generation:n,asked:r?mg(r):"",outcome:{...s,json:l}};this.results.set(o,c),s.ok&&this.good.set(o,{...c,file:this.state.file})}}}};function gg(i,e){let t=e.get(i),n=e.get(Cd(i));return n?.outcome.ok&&(!t||n.generation>t.generation||n.revision>t.revision)?n:t}var Xb=350,jl=class{constructor(e,t){this.engine=e;this.wanted=t;this.found=new Map;this.running=null;this.waiting=new Set;this.timer=0;this.listeners=new Set;this.isRunning=e=>this.running?.key===e;this.rest=()=>{clearTimeout(this.timer),this.timer=window.setTimeout(()=>this.next(),Xb)}}result(e){let{outcome:t}=this.found.get(e)??{outcome:null};return t?.ok?t.json:null}failure(e){let{outcome:t}=this.found.get(e)??{outcome:null};return t&&!t.ok?t.failure||t.problems.map(n=>n.message).join(`
`):""}isOld(e){let t=this.wanted().find(n=>n.key===e);return t!==void 0&&this.found.get(e)?.identity!==Yl(t)}takesLong(e){let t=this.wanted().find(r=>r.key===e),n=this.found.get(e);if(t?.patience===void 0||this.waiting.has(e))return!1;let s=Yl(t);return n?.identity!==s&&(t.patience===0||n?.givenUp===s)}waitFor(e){this.waiting.add(e);let t=this.found.get(e);t&&(t.givenUp=""),this.next()}yield(){this.running?.stop.abort(),this.rest()}subscribe(e){return this.listeners.add(e),()=>this.listeners.delete(e)}next(){if(this.running)return;let e=this.wanted().find(t=>{let n=this.found.get(t.key),s=Yl(t);return(t.patience!==0||this.waiting.has(t.key))&&n?.identity!==s&&n?.givenUp!==s});e&&this.ask(e,Yl(e))}async ask({key:e,change:t,want:n,patience:s},r){let o=new AbortController,a=!1,l=s&&!this.waiting.has(e)?window.setTimeout(()=>{a=!0,o.abort()},s):0;this.running={key:e,identity:r,stop:o},this.notify();try{let c=await this.engine.ask(0,t,[n],o.signal);this.found.set(e,{identity:r,givenUp:"",outcome:c.results[0]??_g(c.problems[0]?.message??"")})}catch(c){let h=this.found.get(e);a?this.found.set(e,{...h?.outcome?.ok?h:{identity:"",outcome:null},givenUp:r}):o.signal.aborted||this.found.set(e,{identity:r,givenUp:"",outcome:_g(c instanceof ci?c.message:String(c))})}clearTimeout(l),o.signal.aborted||this.waiting.delete(e),this.running=null,this.notify(),o.signal.aborted&&!a?this.rest():this.next()}notify(){for(let e of this.listeners)e()}},Yl=({change:i,want:e})=>JSON.stringify([i,e]),_g=i=>({command:"",ok:!1,problems:[],failure:i,json:null});var Zl=class{constructor(){this.theme=matchMedia("(prefers-color-scheme: dark)").matches?"dark":"light";this.frequencyUnit="Hz";this.logarithmicFrequency=!1;this.decibel=!1;this.logarithmicAmplitude=!0;this.shown={kind:"mode",number:1};this.damped=!1;this.playing=!matchMedia("(prefers-reduced-motion: reduce)").matches;this.share=.04;this.speed=.5;this.phase=0;this.traces=!1;this.ghost="edges";this.colouring="none";this.cursor=null;this.drawn=[];this.pins=[];this.leftTab="sliders";this.compared=new Map;this.quantity="";this.table=null;this.notice="";this.listed="";this.listeners=new Set}set(e){Object.assign(this,e);for(let t of this.listeners)t()}subscribe(e){return this.listeners.add(e),()=>this.listeners.delete(e)}};function yg(i,e,t=!1){if(i===0)return"0";let n=Math.abs(i),s=n>=1e6||n<1e-4?i.toExponential(e-1):i.toPrecision(e);return t||!/[.e]/.test(s)?s:s.includes("e")?s.replace(/\.?0*e\+?/,"e"):s.replace(/\.?0+$/,"")}var xg=(i,e)=>e.findLast(([t])=>i>=t*(1-1e-9))??e[0];var vg=2*Math.PI,hi={Hz:1/vg,rpm:60/vg,"rad/s":1};function He(i,e=4){return i==null||Number.isNaN(i)?"–":Number.isFinite(i)?yg(i,e).replace("-","−"):i>0?"∞":"−∞"}var bg=[[1e-9,"n"],[1e-6,"µ"],[.001,"m"],[1,""],[1e3,"k"],[1e6,"M"]],Yb=new Set(["m","m/s","m/s^2","m/s2","m/s²","rad","rad/s","rad/s^2","s"]),jb=1e-4,Zb=/^(m|N|rad|W|J|Pa|s)\b/,Kb={m:"displacement",rad:"rotation","m/s":"velocity","rad/s":"angular velocity","m/s^2":"acceleration","m/s2":"acceleration","m/s²":"acceleration","rad/s^2":"angular acceleration","rad/s2":"angular acceleration","rad/s²":"angular acceleration",N:"force","N m":"moment"},no=i=>Kb[i]??i;function Kl(i,e){let t=e.replace("^2","²").replace("s2","s²");if(!Zb.test(e)||!(i>0))return{factor:1,unit:t};let[n,s]=xg(i,Yb.has(e)?bg.filter(([l])=>l<=1):bg),r=e==="m/s"&&n===1e-6&&i>=jb*(1-1e-9),[o,a]=r?[.001,"m"]:[n,s];return{factor:1/o,unit:a+t}}function Jl(i,e,{level:t,level_factor:n=1}={}){let s=Kl(i*n,e);return{factor:s.factor*n,unit:t?`${s.unit} ${t}`:s.unit}}var Sg=i=>i?Jb[i]:1,Jb={"0-p":1,"p-p":2,rms:Math.SQRT1_2};function ns(i,e,t=4){if(i==null||!Number.isFinite(i))return He(i);let n=Kl(Math.abs(i),e);return`${He(i*n.factor,t)} ${n.unit}`.trim()}var is=(i,e,t=4)=>i===null?"–":`${He(i*hi[e],t)} ${e}`;function Dn(i){let e=i.trim().match(/^"?\s*([-+−]?(?:\d[\d_]*\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*([^"]*?)\s*"?$/);if(!e)return null;let t=Number(e[1].replaceAll("_","").replace("−","-"));return Number.isFinite(t)?{value:t,unit:e[2]}:null}var ys=(i,e)=>{let t=String(Number(i.toPrecision(6)));return e?`"${t} ${e}"`:t};var Qb=["requirements","limits","limit_lines","clearances","operation"],ei=i=>[...i.index.byPath.values()].some(({path:e})=>{let[t,n]=e[0]==="cases"?e.slice(2):e;return Qb.includes(String(t))&&(t!=="operation"||n==="limits")}),Mg=i=>i.case?`case ${i.case}`:"the base model",eS=i=>i.requirements.some(e=>e.judged&&!e.met);function wg(i){let{asker:e,state:t}=i,n=e.problems.filter(r=>r.severity==="error");if(n.length)return{state:"error",words:n.length===1?"1 error in the file":`${n.length} errors in the file`,old:!1};let s=e.result("verdict");if(s){let r=s.cases.find(g=>g.case===t.case)??s.cases[0],o=r?.requirements??[],a=o.filter(g=>g.judged&&!g.met),l=o.filter(g=>!g.judged),c=e.isOld("verdict"),h=l.length?`${l.length} of ${o.length} requirements not judged`:"",u=[...a.length?[`${a.length} of ${o.length} requirements violated`]:[],...h?[h]:[]].join(", ");if(!r?.met&&r?.decides!==!1)return{state:a.length?"violated":"unjudged",words:u||"not met",old:c};let d=s.cases.find(g=>g!==r&&g.decides&&!g.met),f=d?`${eS(d)?"violated":"not judged"} in ${Mg(d)}`:"",p=`${u} here, not binding`;if(f)return{state:"violated",words:r.met?`met here, ${f}`:`${f}; ${p}`,old:c};if(!r.met)return{state:"unbinding",words:p,old:c};let _=s.least_margin,m=_&&_.case!==r.case?` in ${Mg(_)}`:"";return{state:"met",words:`${o.length===1?"the requirement is":`all ${o.length} requirements`} met${_?`, least margin ${He(_.margin,4)}${m}`:""}`,old:c}}return ei(i)?{state:"unknown",words:e.failure("verdict")?"not judged":"judging",old:!e.failure("verdict")}:{state:"none",words:"no requirements",old:!1}}var Ql=globalThis,tc=Ql.ShadowRoot&&(Ql.ShadyCSS===void 0||Ql.ShadyCSS.nativeShadow)&&"adoptedStyleSheets"in Document.prototype&&"replace"in CSSStyleSheet.prototype,Tg=Symbol(),Eg=new WeakMap,ec=class{constructor(e,t,n){if(this._$cssResult$=!0,n!==Tg)throw Error("CSSResult is not constructable. Use `unsafeCSS` or `css` instead.");this.cssText=e,this.t=t}get styleSheet(){let e=this.o,t=this.t;if(tc&&e===void 0){let n=t!==void 0&&t.length===1;n&&(e=Eg.get(t)),e===void 0&&((this.o=e=new CSSStyleSheet).replaceSync(this.cssText),n&&Eg.set(t,e))}return e}toString(){return this.cssText}},Ag=i=>new ec(typeof i=="string"?i:i+"",void 0,Tg);var Cg=(i,e)=>{if(tc)i.adoptedStyleSheets=e.map(t=>t instanceof CSSStyleSheet?t:t.styleSheet);else for(let t of e){let n=document.createElement("style"),s=Ql.litNonce;s!==void 0&&n.setAttribute("nonce",s),n.textContent=t.cssText,i.appendChild(n)}},Rd=tc?i=>i:i=>i instanceof CSSStyleSheet?(e=>{let t="";for(let n of e.cssRules)t+=n.cssText;return Ag(t)})(i):i;var{is:tS,defineProperty:nS,getOwnPropertyDescriptor:iS,getOwnPropertyNames:sS,getOwnPropertySymbols:rS,getPrototypeOf:oS}=Object,nc=globalThis,Rg=nc.trustedTypes,aS=Rg?Rg.emptyScript:"",lS=nc.reactiveElementPolyfillSupport,_a=(i,e)=>i,Pd={toAttribute(i,e){switch(e){case Boolean:i=i?aS:null;break;case Object:case Array:i=i==null?i:JSON.stringify(i)}return i},fromAttribute(i,e){let t=i;switch(e){case Boolean:t=i!==null;break;case Number:t=i===null?null:Number(i);break;case Object:case Array:try{t=JSON.parse(i)}catch{t=null}}return t}},Ig=(i,e)=>!tS(i,e),Pg={attribute:!0,type:String,converter:Pd,reflect:!1,useDefault:!1,hasChanged:Ig};Symbol.metadata??=Symbol("metadata"),nc.litPropertyMetadata??=new WeakMap;var xs=class extends HTMLElement{static addInitializer(e){this._$Ei(),(this.l??=[]).push(e)}static get observedAttributes(){return this.finalize(),this._$Eh&&[...this._$Eh.keys()]}static createProperty(e,t=Pg){if(t.state&&(t.attribute=!1),this._$Ei(),this.prototype.hasOwnProperty(e)&&((t=Object.create(t)).wrapped=!0),this.elementProperties.set(e,t),!t.noAccessor){let n=Symbol(),s=this.getPropertyDescriptor(e,n,t);s!==void 0&&nS(this.prototype,e,s)}}static getPropertyDescriptor(e,t,n){let{get:s,set:r}=iS(this.prototype,e)??{get(){return this[t]},set(o){this[t]=o}};return{get:s,set(o){let a=s?.call(this);r?.call(this,o),this.requestUpdate(e,a,n)},configurable:!0,enumerable:!0}}static getPropertyOptions(e){return this.elementProperties.get(e)??Pg}static _$Ei(){if(this.hasOwnProperty(_a("elementProperties")))return;let e=oS(this);e.finalize(),e.l!==void 0&&(this.l=[...e.l]),this.elementProperties=new Map(e.elementProperties)}static finalize(){if(this.hasOwnProperty(_a("finalized")))return;if(this.finalized=!0,this._$Ei(),this.hasOwnProperty(_a("properties"))){let t=this.properties,n=[...sS(t),...rS(t)];for(let s of n)this.createProperty(s,t[s])}let e=this[Symbol.metadata];if(e!==null){let t=litPropertyMetadata.get(e);if(t!==void 0)for(let[n,s]of t)this.elementProperties.set(n,s)}this._$Eh=new Map;for(let[t,n]of this.elementProperties){let s=this._$Eu(t,n);s!==void 0&&this._$Eh.set(s,t)}this.elementStyles=this.finalizeStyles(this.styles)}static finalizeStyles(e){let t=[];if(Array.isArray(e)){let n=new Set(e.flat(1/0).reverse());for(let s of n)t.unshift(Rd(s))}else e!==void 0&&t.push(Rd(e));return t}static _$Eu(e,t){let n=t.attribute;return n===!1?void 0:typeof n=="string"?n:typeof e=="string"?e.toLowerCase():void 0}constructor(){super(),this._$Ep=void 0,this.isUpdatePending=!1,this.hasUpdated=!1,this._$Em=null,this._$Ev()}_$Ev(){this._$ES=new Promise(e=>this.enableUpdating=e),this._$AL=new Map,this._$E_(),this.requestUpdate(),this.constructor.l?.forEach(e=>e(this))}addController(e){(this._$EO??=new Set).add(e),this.renderRoot!==void 0&&this.isConnected&&e.hostConnected?.()}removeController(e){this._$EO?.delete(e)}_$E_(){let e=new Map,t=this.constructor.elementProperties;for(let n of t.keys())this.hasOwnProperty(n)&&(e.set(n,this[n]),delete this[n]);e.size>0&&(this._$Ep=e)}createRenderRoot(){let e=this.shadowRoot??this.attachShadow(this.constructor.shadowRootOptions);return Cg(e,this.constructor.elementStyles),e}connectedCallback(){this.renderRoot??=this.createRenderRoot(),this.enableUpdating(!0),this._$EO?.forEach(e=>e.hostConnected?.())}enableUpdating(e){}disconnectedCallback(){this._$EO?.forEach(e=>e.hostDisconnected?.())}attributeChangedCallback(e,t,n){this._$AK(e,n)}_$ET(e,t){let n=this.constructor.elementProperties.get(e),s=this.constructor._$Eu(e,n);if(s!==void 0&&n.reflect===!0){let r=(n.converter?.toAttribute!==void 0?n.converter:Pd).toAttribute(t,n.type);this._$Em=e,r==null?this.removeAttribute(s):this.setAttribute(s,r),this._$Em=null}}_$AK(e,t){let n=this.constructor,s=n._$Eh.get(e);if(s!==void 0&&this._$Em!==s){let r=n.getPropertyOptions(s),o=typeof r.converter=="function"?{fromAttribute:r.converter}:r.converter?.fromAttribute!==void 0?r.converter:Pd;this._$Em=s;let a=o.fromAttribute(t,r.type);this[s]=a??this._$Ej?.get(s)??a,this._$Em=null}}requestUpdate(e,t,n,s=!1,r){if(e!==void 0){let o=this.constructor;if(s===!1&&(r=this[e]),n??=o.getPropertyOptions(e),!((n.hasChanged??Ig)(r,t)||n.useDefault&&n.reflect&&r===this._$Ej?.get(e)&&!this.hasAttribute(o._$Eu(e,n))))return;this.C(e,t,n)}this.isUpdatePending===!1&&(this._$ES=this._$EP())}C(e,t,{useDefault:n,reflect:s,wrapped:r},o){n&&!(this._$Ej??=new Map).has(e)&&(this._$Ej.set(e,o??t??this[e]),r!==!0||o!==void 0)||(this._$AL.has(e)||(this.hasUpdated||n||(t=void 0),this._$AL.set(e,t)),s===!0&&this._$Em!==e&&(this._$Eq??=new Set).add(e))}async _$EP(){this.isUpdatePending=!0;try{await this._$ES}catch(t){Promise.reject(t)}let e=this.scheduleUpdate();return e!=null&&await e,!this.isUpdatePending}scheduleUpdate(){return this.performUpdate()}performUpdate(){if(!this.isUpdatePending)return;if(!this.hasUpdated){if(this.renderRoot??=this.createRenderRoot(),this._$Ep){for(let[s,r]of this._$Ep)this[s]=r;this._$Ep=void 0}let n=this.constructor.elementProperties;if(n.size>0)for(let[s,r]of n){let{wrapped:o}=r,a=this[s];o!==!0||this._$AL.has(s)||a===void 0||this.C(s,void 0,r,a)}}let e=!1,t=this._$AL;try{e=this.shouldUpdate(t),e?(this.willUpdate(t),this._$EO?.forEach(n=>n.hostUpdate?.()),this.update(t)):this._$EM()}catch(n){throw e=!1,this._$EM(),n}e&&this._$AE(t)}willUpdate(e){}_$AE(e){this._$EO?.forEach(t=>t.hostUpdated?.()),this.hasUpdated||(this.hasUpdated=!0,this.firstUpdated(e)),this.updated(e)}_$EM(){this._$AL=new Map,this.isUpdatePending=!1}get updateComplete(){return this.getUpdateComplete()}getUpdateComplete(){return this._$ES}shouldUpdate(e){return!0}update(e){this._$Eq&&=this._$Eq.forEach(t=>this._$ET(t,this[t])),this._$EM()}updated(e){}firstUpdated(e){}};xs.elementStyles=[],xs.shadowRootOptions={mode:"open"},xs[_a("elementProperties")]=new Map,xs[_a("finalized")]=new Map,lS?.({ReactiveElement:xs}),(nc.reactiveElementVersions??=[]).push("2.1.2");var Ld=globalThis,Lg=i=>i,ic=Ld.trustedTypes,Dg=ic?ic.createPolicy("lit-html",{createHTML:i=>i}):void 0,Dd="$lit$",vs=`lit$${Math.random().toFixed(9).slice(2)}$`,Nd="?"+vs,cS=`<${Nd}>`,br=document,xa=()=>br.createComment(""),va=i=>i===null||typeof i!="object"&&typeof i!="function",Od=Array.isArray,Bg=i=>Od(i)||typeof i?.[Symbol.iterator]=="function",Id=`[ 	
\f\r]`,ya=/<(?:(!--|\/[^a-zA-Z])|(\/?[a-zA-Z][^>\s]*)|(\/?$))/g,Ng=/-->/g,Og=/>/g,xr=RegExp(`>|${Id}(?:([^\\s"'>=/]+)(${Id}*=${Id}*(?:[^ 	
\f\r"'\`<>=]|("|')|))|$)`,"g"),Ug=/'/g,Fg=/"/g,zg=/^(?:script|style|textarea|title)$/i,Ud=i=>(e,...t)=>({_$litType$:i,strings:e,values:t}),re=Ud(1),so=Ud(2),rL=Ud(3),Sr=Symbol.for("lit-noChange"),Re=Symbol.for("lit-nothing"),kg=new WeakMap,vr=br.createTreeWalker(br,129);function Vg(i,e){if(!Od(i)||!i.hasOwnProperty("raw"))throw Error("invalid template strings array");return Dg!==void 0?Dg.createHTML(e):e}var Gg=(i,e)=>{let t=i.length-1,n=[],s,r=e===2?"<svg>":e===3?"<math>":"",o=ya;for(let a=0;a<t;a++){let l=i[a],c,h,u=-1,d=0;for(;d<l.length&&(o.lastIndex=d,h=o.exec(l),h!==null);)d=o.lastIndex,o===ya?h[1]==="!--"?o=Ng:h[1]!==void 0?o=Og:h[2]!==void 0?(zg.test(h[2])&&(s=RegExp("</"+h[2],"g")),o=xr):h[3]!==void 0&&(o=xr):o===xr?h[0]===">"?(o=s??ya,u=-1):h[1]===void 0?u=-2:(u=o.lastIndex-h[2].length,c=h[1],o=h[3]===void 0?xr:h[3]==='"'?Fg:Ug):o===Fg||o===Ug?o=xr:o===Ng||o===Og?o=ya:(o=xr,s=void 0);let f=o===xr&&i[a+1].startsWith("/>")?" ":"";r+=o===ya?l+cS:u>=0?(n.push(c),l.slice(0,u)+Dd+l.slice(u)+vs+f):l+vs+(u===-2?a:f)}return[Vg(i,r+(i[t]||"<?>")+(e===2?"</svg>":e===3?"</math>":"")),n]},ba=class i{constructor({strings:e,_$litType$:t},n){let s;this.parts=[];let r=0,o=0,a=e.length-1,l=this.parts,[c,h]=Gg(e,t);if(this.el=i.createElement(c,n),vr.currentNode=this.el.content,t===2||t===3){let u=this.el.content.firstChild;u.replaceWith(...u.childNodes)}for(;(s=vr.nextNode())!==null&&l.length<a;){if(s.nodeType===1){if(s.hasAttributes())for(let u of s.getAttributeNames())if(u.endsWith(Dd)){let d=h[o++],f=s.getAttribute(u).split(vs),p=/([.?@])?(.*)/.exec(d);l.push({type:1,index:r,name:p[2],strings:f,ctor:p[1]==="."?rc:p[1]==="?"?oc:p[1]==="@"?ac:wr}),s.removeAttribute(u)}else u.startsWith(vs)&&(l.push({type:6,index:r}),s.removeAttribute(u));if(zg.test(s.tagName)){let u=s.textContent.split(vs),d=u.length-1;if(d>0){s.textContent=ic?ic.emptyScript:"";for(let f=0;f<d;f++)s.append(u[f],xa()),vr.nextNode(),l.push({type:2,index:++r});s.append(u[d],xa())}}}else if(s.nodeType===8)if(s.data===Nd)l.push({type:2,index:r});else{let u=-1;for(;(u=s.data.indexOf(vs,u+1))!==-1;)l.push({type:7,index:r}),u+=vs.length-1}r++}}static createElement(e,t){let n=br.createElement("template");return n.innerHTML=e,n}};function Mr(i,e,t=i,n){if(e===Sr)return e;let s=n!==void 0?t._$Co?.[n]:t._$Cl,r=va(e)?void 0:e._$litDirective$;return s?.constructor!==r&&(s?._$AO?.(!1),r===void 0?s=void 0:(s=new r(i),s._$AT(i,t,n)),n!==void 0?(t._$Co??=[])[n]=s:t._$Cl=s),s!==void 0&&(e=Mr(i,s._$AS(i,e.values),s,n)),e}var sc=class{constructor(e,t){this._$AV=[],this._$AN=void 0,this._$AD=e,this._$AM=t}get parentNode(){return this._$AM.parentNode}get _$AU(){return this._$AM._$AU}u(e){let{el:{content:t},parts:n}=this._$AD,s=(e?.creationScope??br).importNode(t,!0);vr.currentNode=s;let r=vr.nextNode(),o=0,a=0,l=n[0];for(;l!==void 0;){if(o===l.index){let c;l.type===2?c=new io(r,r.nextSibling,this,e):l.type===1?c=new l.ctor(r,l.name,l.strings,this,e):l.type===6&&(c=new lc(r,this,e)),this._$AV.push(c),l=n[++a]}o!==l?.index&&(r=vr.nextNode(),o++)}return vr.currentNode=br,s}p(e){let t=0;for(let n of this._$AV)n!==void 0&&(n.strings!==void 0?(n._$AI(e,n,t),t+=n.strings.length-2):n._$AI(e[t])),t++}},io=class i{get _$AU(){return this._$AM?._$AU??this._$Cv}constructor(e,t,n,s){this.type=2,this._$AH=Re,this._$AN=void 0,this._$AA=e,this._$AB=t,this._$AM=n,this.options=s,this._$Cv=s?.isConnected??!0}get parentNode(){let e=this._$AA.parentNode,t=this._$AM;return t!==void 0&&e?.nodeType===11&&(e=t.parentNode),e}get startNode(){return this._$AA}get endNode(){return this._$AB}_$AI(e,t=this){e=Mr(this,e,t),va(e)?e===Re||e==null||e===""?(this._$AH!==Re&&this._$AR(),this._$AH=Re):e!==this._$AH&&e!==Sr&&this._(e):e._$litType$!==void 0?this.$(e):e.nodeType!==void 0?this.T(e):Bg(e)?this.k(e):this._(e)}O(e){return this._$AA.parentNode.insertBefore(e,this._$AB)}T(e){this._$AH!==e&&(this._$AR(),this._$AH=this.O(e))}_(e){this._$AH!==Re&&va(this._$AH)?this._$AA.nextSibling.data=e:this.T(br.createTextNode(e)),this._$AH=e}$(e){let{values:t,_$litType$:n}=e,s=typeof n=="number"?this._$AC(e):(n.el===void 0&&(n.el=ba.createElement(Vg(n.h,n.h[0]),this.options)),n);if(this._$AH?._$AD===s)this._$AH.p(t);else{let r=new sc(s,this),o=r.u(this.options);r.p(t),this.T(o),this._$AH=r}}_$AC(e){let t=kg.get(e.strings);return t===void 0&&kg.set(e.strings,t=new ba(e)),t}k(e){Od(this._$AH)||(this._$AH=[],this._$AR());let t=this._$AH,n,s=0;for(let r of e)s===t.length?t.push(n=new i(this.O(xa()),this.O(xa()),this,this.options)):n=t[s],n._$AI(r),s++;s<t.length&&(this._$AR(n&&n._$AB.nextSibling,s),t.length=s)}_$AR(e=this._$AA.nextSibling,t){for(this._$AP?.(!1,!0,t);e!==this._$AB;){let n=Lg(e).nextSibling;Lg(e).remove(),e=n}}setConnected(e){this._$AM===void 0&&(this._$Cv=e,this._$AP?.(e))}},wr=class{get tagName(){return this.element.tagName}get _$AU(){return this._$AM._$AU}constructor(e,t,n,s,r){this.type=1,this._$AH=Re,this._$AN=void 0,this.element=e,this.name=t,this._$AM=s,this.options=r,n.length>2||n[0]!==""||n[1]!==""?(this._$AH=Array(n.length-1).fill(new String),this.strings=n):this._$AH=Re}_$AI(e,t=this,n,s){let r=this.strings,o=!1;if(r===void 0)e=Mr(this,e,t,0),o=!va(e)||e!==this._$AH&&e!==Sr,o&&(this._$AH=e);else{let a=e,l,c;for(e=r[0],l=0;l<r.length-1;l++)c=Mr(this,a[n+l],t,l),c===Sr&&(c=this._$AH[l]),o||=!va(c)||c!==this._$AH[l],c===Re?e=Re:e!==Re&&(e+=(c??"")+r[l+1]),this._$AH[l]=c}o&&!s&&this.j(e)}j(e){e===Re?this.element.removeAttribute(this.name):this.element.setAttribute(this.name,e??"")}},rc=class extends wr{constructor(){super(...arguments),this.type=3}j(e){this.element[this.name]=e===Re?void 0:e}},oc=class extends wr{constructor(){super(...arguments),this.type=4}j(e){this.element.toggleAttribute(this.name,!!e&&e!==Re)}},ac=class extends wr{constructor(e,t,n,s,r){super(e,t,n,s,r),this.type=5}_$AI(e,t=this){if((e=Mr(this,e,t,0)??Re)===Sr)return;let n=this._$AH,s=e===Re&&n!==Re||e.capture!==n.capture||e.once!==n.once||e.passive!==n.passive,r=e!==Re&&(n===Re||s);s&&this.element.removeEventListener(this.name,this,n),r&&this.element.addEventListener(this.name,this,e),this._$AH=e}handleEvent(e){typeof this._$AH=="function"?this._$AH.call(this.options?.host??this.element,e):this._$AH.handleEvent(e)}},lc=class{constructor(e,t,n){this.element=e,this.type=6,this._$AN=void 0,this._$AM=t,this.options=n}get _$AU(){return this._$AM._$AU}_$AI(e){Mr(this,e)}},Hg={M:Dd,P:vs,A:Nd,C:1,L:Gg,R:sc,D:Bg,V:Mr,I:io,H:wr,N:oc,U:ac,B:rc,F:lc},hS=Ld.litHtmlPolyfillSupport;hS?.(ba,io),(Ld.litHtmlVersions??=[]).push("3.3.3");var Wg=(i,e,t)=>{let n=t?.renderBefore??e,s=n._$litPart$;if(s===void 0){let r=t?.renderBefore??null;n._$litPart$=s=new io(e.insertBefore(xa(),r),r,void 0,t??{})}return s._$AI(i),s};var Fd=globalThis,Xs=class extends xs{constructor(){super(...arguments),this.renderOptions={host:this},this._$Do=void 0}createRenderRoot(){let e=super.createRenderRoot();return this.renderOptions.renderBefore??=e.firstChild,e}update(e){let t=this.render();this.hasUpdated||(this.renderOptions.isConnected=this.isConnected),super.update(e),this._$Do=Wg(t,this.renderRoot,this.renderOptions)}connectedCallback(){super.connectedCallback(),this._$Do?.setConnected(!0)}disconnectedCallback(){super.disconnectedCallback(),this._$Do?.setConnected(!1)}render(){return Sr}};Xs._$litElement$=!0,Xs.finalized=!0,Fd.litElementHydrateSupport?.({LitElement:Xs});var uS=Fd.litElementPolyfillSupport;uS?.({LitElement:Xs});(Fd.litElementVersions??=[]).push("4.2.2");var dS=["x","y","z"];function fS(i,e){let t=[...i.path];if(t[0]==="parameters"||t[0]==="trivet")return null;if(t[0]==="tables"){if(t[2]!=="rows"||t[3]===void 0)return null;let r=e.get(t.slice(0,4).join("\0")),o=r?.children.find(a=>a.path.at(-1)==="name");if(!o)return null;t=[t[1],o.raw.slice(1,-1),...t.slice(4)]}let s=i.path.map((r,o)=>e.get(i.path.slice(0,o+1).join("\0"))).filter(r=>r?.kind==="array").filter(r=>r.path[0]!=="tables"||r.path.length>3);if(s.length>1)return null;if(s.length===1){if(s[0].children.length!==3||s[0]!==e.get(i.path.slice(0,-1).join("\0")))return null;t[t.length-1]=dS[Number(t.at(-1))]}return Oi(t)}function kd(i,e,t){let n=e?Oi(["cases",e,...yr(i)]):i;return t.numbers.has(n)?n:i}function $g(i){let e=lg(i),t=new Map;for(let s of Td(e))t.set(s.path.join("\0"),s);let n=new Map;for(let s of t.values()){let r=s.kind==="number"?fS(s,t):null;r&&n.set(r,s)}return{entries:e,byPath:t,numbers:n}}var Sa=({byPath:i})=>["",...new Set([...i.values()].filter(e=>e.path[0]==="cases"&&e.path.length>1).map(e=>e.path[1]))];function qg(i,e){let t=[];for(let n of i.keys())for(let s of n.startsWith("cases.")?[]:Sa(e)){let r=kd(n,s,e),o=e.numbers.get(r);r!==n&&o&&!i.has(r)&&t.push([r,o.raw])}return t}function pS(i,e,t){return e.settings.get(i)??t.numbers.get(i)?.raw??null}var Ys=(i,e,t)=>{let n=pS(i,e,t);return n===null?null:Dn(n)};var cc=class{constructor(e,t,n,s,r,o,a=null){this.engine=e;this.project=t;this.state=n;this.display=s;this.asker=r;this.beside=o;this.sampler=a;this.schema=null;this.file=null}get cases(){return Sa(this.index)}get index(){return this.state.index}},vn=class extends Xs{constructor(){super(...arguments);this.unsubscribe=[]}static{this.properties={app:{attribute:!1}}}createRenderRoot(){return this}connectedCallback(){super.connectedCallback();let t=()=>this.requestUpdate(),{state:n,display:s,asker:r,file:o}=this.app;this.unsubscribe=[n,s,r,...o?[o]:[]].map(a=>a.subscribe(t))}disconnectedCallback(){super.disconnectedCallback();for(let t of this.unsubscribe)t()}};var Xg={text:"\0",settings:new Map},hc=class{constructor(){this.design={text:"",settings:new Map};this.case="";this.selection=null;this.revision=0;this.generation=0;this.file=0;this.past=[];this.future=[];this.saved=this.design;this.opened={text:"",version:null};this.indexed=null;this.dragged=null;this.listeners=new Set}open(e,t,n=[],s=""){this.design={text:e,settings:new Map(n)},this.opened={text:e,version:t},this.saved=t===null?Xg:this.design,[this.past,this.future,this.selection,this.case]=[[],[],null,s],this.file++,this.changed(!0)}get change(){let{text:e,settings:t}=this.design,n=t.size?qg(t,this.index):[];return{text:e,version:e===this.opened.text?this.opened.version:null,settings:[...t,...n].map(([s,r])=>`${s} = ${r}`),case:this.case}}get index(){let{text:e}=this.design;return this.indexed?.text!==e&&(this.indexed={text:e,index:$g(e)}),this.indexed.index}get hasEdits(){return this.design.text!==this.opened.text||this.design.settings.size>0}get isSaved(){return this.design.text===this.saved.text&&this.design.settings.size===0}get history(){return{past:this.past,future:this.future}}get canUndo(){return this.past.length>0}get canRedo(){return this.future.length>0}set(e,t=!1){let n=this.design,s=new Map(n.settings);for(let[r,o]of Object.entries(e))s.set(r,o);t?this.dragged??=n:this.remember(this.dragged??n),t||(this.dragged=null),this.design={text:n.text,settings:s},this.changed(!1)}dropped(){this.dragged&&this.remember(this.dragged),this.dragged=null,this.notify()}edit(e){this.write(e,!1)}replaceNumber(e,t){this.replaceNumbers([[e,t]])}replaceNumbers(e){let t=[...e].sort((n,s)=>s[0].from-n[0].from);this.write(t.reduce((n,[{from:s,to:r},o])=>n.slice(0,s)+o+n.slice(r),this.design.text),!0)}folded(e){this.design={text:e,settings:new Map},this.changed(!1)}undo(){this.travel(this.past,this.future)}redo(){this.travel(this.future,this.past)}wasSaved(e,t,n=this.design){this.saved={text:e,settings:new Map},this.design===n&&(this.design=this.saved),this.opened={text:e,version:t},this.changed(!1)}replaced(e,t){this.remember(this.design),this.design=this.saved={text:e,settings:new Map},this.opened={text:e,version:t},Sa(this.index).includes(this.case)||(this.case=""),this.changed(!0)}foundOnDisk(e,t){if(e===this.design.text&&!this.design.settings.size)this.wasSaved(e,t);else if(this.opened.version===null&&e===this.opened.text)[this.saved,this.opened]=[{text:e,settings:new Map},{text:e,version:t}];else return!1;return this.changed(!1),!0}wasDeleted(){this.opened={text:this.opened.text,version:null},this.saved=Xg,this.changed(!1)}put(e,t){this.remember(this.design,this.case),this.design=e,this.case=t,this.changed(!0)}resume(e,t,{past:n,future:s}){if(!n.length)return this.put(e,t);[this.past,this.future,this.design,this.case]=[[...n],[...s],e,t],this.changed(!0)}chooseCase(e){this.case=e,this.changed(!0)}select(e){this.selection=e,this.notify()}subscribe(e){return this.listeners.add(e),()=>this.listeners.delete(e)}write(e,t){e!==this.design.text&&(this.remember(this.design,null,t),this.design={text:e,settings:this.design.settings},this.changed(!t))}remember(e,t=null,n=!1){this.past.push({design:e,case:t,...n?{isNumber:n}:{}}),this.future=[]}travel(e,t){let n=e.pop();if(!n)return;let{isNumber:s=!1}=n;t.push({design:this.design,case:n.case===null?null:this.case,...s?{isNumber:s}:{}});let r=(s||n.design.text===this.design.text)&&(n.case??this.case)===this.case;this.design=n.design,this.case=n.case??this.case,this.changed(!r)}changed(e){this.revision++,e&&this.generation++,this.notify()}notify(){for(let e of this.listeners)e()}};var Yg=1024,mS=1e5,gS=1e5,uc="few designs",Zg=({state:{design:i,index:e}})=>Ys("analyses.sample.designs",i,e)?.value??gS,jg=i=>[`analyses.sample.designs = ${i}`,"analyses.sample.worst_case = false"];function Bd(i){let{state:e,index:t}=i,n=[...t.byPath.keys()].some(o=>o.startsWith("tolerances\0"));if(!e.design.text||!n||!ei(i))return[];let s=Zg(i),r={want:{command:"sample"},as:uc,settings:jg(Math.min(Yg,s))};return s<=Yg||!_S(i)?[r]:[r,{want:{command:"sample"},slow:!0,settings:jg(Math.min(mS,s))}]}var _S=({sampler:i})=>i?.result(uc)?.cases.every(e=>e.no_kernels==="")??!0;function zd(i){let{sampler:e}=i,t=e?Bd(i):[];if(!e||!t.length||e.hasErrors)return null;let n=e.revisionOf(uc)>e.revisionOf("sample")?uc:"sample",s=e.result(n);return s&&{found:s,old:t.some(r=>e.isOld(r.as??"sample")),wanted:Zg(i)}}var Kg=({found:i},e)=>i.bands?.find(t=>t.case===e)?.results??yS,yS=[];var xS="kept",Vd="case ",Gd="three springs",dc="measured",Jg=[[7,3],[2,3],[9,3,2,3],[4,2,1,2,1,2]];function Hd(i){if(!i.engine.isLive)return[];let{cases:e,state:t,index:n}=i,s=[...n.byPath.values()].some(r=>r.path[0]==="measurements");return[...e.filter(r=>r!==t.case).map(r=>Vd+r),Gd,...s?[dc]:[]]}var Wd=i=>i===Vd?"base model":i===Gd?"mounts as three springs":i,$d=i=>Hd(i).filter(e=>i.display.compared.get(e)??e===dc),Qg=(i,e)=>$d(i).includes(e);function e0(i){let{change:e}=i.state,{quantity:t}=i.display,n=t?{quantity:t}:{};return $d(i).map(s=>s===dc?{key:s,change:e,want:{command:"measurements"}}:s===Gd?{key:s,change:e,want:{command:"curves",keys:{...n,"three-springs":!0}}}:{key:s,change:{...e,case:s.slice(Vd.length)},want:{command:"curves",keys:n}})}function t0(i,e){let{beside:t}=i,n=i.asker.result("curves")?.models[0]?.excitations??[],s=$d(i).map((r,o)=>{let a=r===dc?t.result(r)??[]:void 0,l=a?.map(c=>c.excitation).filter(c=>c!==null&&!(n.length===1&&n[0]===c))??[];return{key:r,label:Wd(r)+(l.length?` (${l.join(", ")} alone)`:""),curves:a?null:t.result(r),...a?{measured:a}:{},old:t.isOld(r),failure:t.failure(r),dash:Jg[o%Jg.length]}});return e?[...s,{key:xS,label:"kept",curves:e,old:!1,failure:"",dash:[4,3]}]:s}var n0={m:1,s:1,N:1,Hz:2*Math.PI,rpm:2*Math.PI/60,rad:1,deg:Math.PI/180,Pa:1,W:1,J:1,g:.001,t:1e3,"%":.01,kg:1,min:60,Nm:1,bar:1e5},vS={k:1e3,M:1e6,G:1e9,c:.01,m:.001,µ:1e-6,u:1e-6,n:1e-9};function i0(i){let e=1,t=1;for(let n of i.replaceAll("·"," ").split(/(\/)|\s+/).filter(Boolean)){if(n==="/"){t=-1;continue}let s=n.match(/^([^\d^]+)\^?(\d)?$/),r=s?.[1]??"",o=Number(s?.[2]??1),a=n0[r]??(vS[r[0]??""]??NaN)*(n0[r.slice(1)]??NaN);if(!Number.isFinite(a))return null;e*=a**(t*o)}return e}function Er(i,e,t){let n=i0(e),s=i0(t);return e===t?i:n===null||s===null?null:i*n/s}function fc(i,e,t,n="",s=null){let r=l=>kd(l,n,e),o=bS(i,e,r),a=t.map(l=>a0(l,i,e,r)).filter(l=>l!==null);return o.length||a.length||!s?[...o,...a]:SS(i,e,r,s)}var Ma=({paths:i,unit:e},t)=>Object.fromEntries(i.map(({path:n,factor:s})=>[n,ys(t*s,e)])),r0=(i,e)=>o0(e.byPath.get(["parameters",i,"path"].join("\0")),e),Tr=i=>(i?.raw??"").replace(/^["']|["']$/g,"");function bS(i,e,t){let n=new Set([...e.byPath.values()].filter(r=>r.path[0]==="parameters"&&r.path.length>1).map(r=>r.path[1])),s=[];for(let r of n){let o=f=>e.byPath.get(["parameters",r,f].join("\0")),a=Dn(o("from")?.raw??""),l=Dn(o("to")?.raw??""),c=o0(o("path"),e).map(f=>({...f,path:t(f.path)}));if(!a||!l||!c.length)continue;let h=l.unit||a.unit,u=Ys(c[0].path,i,e),d=Math.min(Math.max(1,a.value),l.value);s.push({name:r,paths:c,unit:h,from:Er(a.value,a.unit,h)??a.value,to:l.value,logarithmic:Tr(o("spacing"))==="logarithmic",...qd(u,h,d,c[0].factor)})}return s}function o0(i,e){return i?.kind==="array"?i.children.map(n=>({path:Tr(n),factor:1})):i?.kind==="table"?i.children.map(n=>({path:n.path.slice(3).join("."),factor:Dn(n.raw)?.value??1})):i?[{path:Tr(i),factor:1}]:[...e.byPath.values()].filter(n=>n.path[0]==="parameters"&&n.path[2]==="path"&&n.kind==="number").map(n=>({path:n.path.slice(3).join("."),factor:Dn(n.raw)?.value??1}))}function a0(i,e,t,n){let s=n(i),r=t.numbers.get(s)?.raw,o=r?Dn(r):{value:1,unit:""},a=Ys(s,e,t)??o;if(!o||!a)return null;let l=Math.abs(o.value),c=l>0?[o.value/2,o.value*2].sort((h,u)=>h-u):[-1,1];return{name:i,paths:[{path:s,factor:1}],from:c[0],to:c[1],logarithmic:o.value>0,unit:o.unit,...qd(a,o.unit,o.value)}}function qd(i,e,t,n=1){let s=i?Er(i.value,i.unit,e):null,r=i!==null&&(s===null||!e&&i.unit!=="");return{value:(s??t)/n,...r?{written:`${He(i.value/n,5)} ${i.unit}`.trim()}:{}}}var s0=4;function SS(i,e,t,n){let r=[...MS(e,n)].flatMap(([l,c])=>c?[{name:l,parts:["element_types",l],key:c}]:[]),o=n.elements.flatMap(({name:l,stiffness_key:c})=>c?[{name:l,parts:["elements",l],key:c}]:[]);return[...(r.length?r:o.slice(0,s0)).map(({name:l,parts:c,key:h})=>l0(`stiffness of ${l}`,t(`${Oi(c)}.${h}`),4,i,e)),...n.bodies.filter(l=>!l.node&&l.mass>0).slice(0,s0).map(({name:l})=>ES(l,i,e,t))]}function MS(i,{elements:e}){let t=new Map;for(let{path:n}of i.byPath.values())n[0]==="element_types"&&n.length>1&&t.set(n[1],"scale");for(let{name:n,stiffness_key:s}of e){let r=wS(n,i);t.has(r)&&t.set(r,s??null)}return t}function wS(i,{byPath:e}){let t=e.get(["elements",i,"type"].join("\0"));if(t)return Tr(t);let n=[...e.values()].find(s=>s.path[0]==="tables"&&s.path.length===5&&s.path[4]==="name"&&Tr(s)===i);return n?Tr(e.get([...n.path.slice(0,4),"type"].join("\0"))):""}function ES(i,e,t,n){let s=["bodies",i],r=Oi([...s,"mass"]),o=t.byPath.get([...s,"inertia","about"].join("\0"));return t.numbers.has(r)&&Tr(o)!=="pole"?{...a0(r,e,t,n),name:`mass of ${i}`}:l0(`mass of ${i}, factor`,n(Oi([...s,"mass_about_center"])),2,e,t)}function l0(i,e,t,n,s){return{name:i,paths:[{path:e,factor:1}],from:1/t,to:t,logarithmic:!0,unit:"",...qd(Ys(e,n,s),"",1)}}var wa=class{constructor(e,t,n,s){this.app=e;this.axis=t;this.map=n;this.which=s}get paths(){return this.slider?.paths.map(e=>e.path)??[this.axis.parameter]}get value(){let{state:e,index:t}=this.app,{axis:n}=this,s=this.paths.some(l=>e.design.settings.has(l)),r=this.map.marks.find(l=>l.case===e.case)?.[this.which]??null;if(!s&&e.case&&r!==null)return r;let{slider:o}=this;if(o)return Er(o.value,o.unit,n.unit);let a=Ys(n.parameter,e.design,t);return a?Er(a.value,a.unit,n.unit):r??(n.unit===""&&n.from<=1&&n.to>=1?1:null)}settings(e){let{slider:t,axis:n}=this,s=Number(e.toPrecision(4));return t?Ma(t,Er(s,n.unit,t.unit)??s):{[n.parameter]:ys(s,n.unit)}}at(e){let{from:t,to:n,spacing:s}=this.axis;return s==="logarithmic"?t*(n/t)**e:t+e*(n-t)}get slider(){let{state:e,index:t}=this.app;return fc(e.design,t,[]).find(n=>n.name===this.axis.parameter)??null}},js=({from:i,to:e,spacing:t},n)=>t==="logarithmic"?Math.log(n/i)/Math.log(e/i):(n-i)/(e-i);function Xd({from:i,to:e,spacing:t},n){if(t==="logarithmic"){let l=[1,2,5],c=Math.log10(e/i)*3>n?[1]:l,h=[];for(let u=Math.floor(Math.log10(i));u<=Math.log10(e);u++)for(let d of c)h.push(Number((d*10**u).toPrecision(3)));return h.filter(u=>u>=i*(1-1e-9)&&u<=e*(1+1e-9))}let s=(e-i)/n,r=10**Math.floor(Math.log10(s)),o=r*([1,2,5,10].find(l=>l*r>=s)??10),a=Math.ceil(i/o-1e-9);return Array.from({length:Math.floor(e/o+1e-9)-a+1},(l,c)=>Number(((a+c)*o).toPrecision(12)))}var c0=({row:i})=>i<=1,ro=(i,e)=>i[0]<e[2]&&i[2]>e[0]&&i[1]<e[3]&&i[3]>e[1];function Yd(i,e,t,n,s=[]){let r=[...s];return i.map(o=>{let a=TS(o,e.width,n).map((u,d)=>({...u,number:d})).filter(({box:u})=>u[1]>=-7.5&&u[3]<=e.height&&!r.some(d=>ro(u,d))),l=u=>i.some(d=>d!==o&&ro(u,[d.left,d.top,d.right,d.top+1])),c=a.filter(({box:u})=>!l(u)&&!t(u)),h=a.find(u=>u.number===o.before)??c.find(u=>u.row===0)??c.find(c0)??a.find(c0)??c[0]??a[0]??null;return h&&r.push(h.box),h&&{number:h.number,box:h.box}})}function TS(i,e,t){return[AS(i,e),CS(i,e)].flatMap(n=>Array.from({length:t},(s,r)=>r).flatMap(s=>n.flatMap(r=>[i.top-(s+1)*15,i.top+s*15+2].map(o=>({row:s,box:[r-i.size,o,r,o+15]})))))}function AS({left:i,right:e,size:t},n){return e-i>=t?Array.from({length:Math.floor((e-i+4)/(t+4))},(r,o)=>e-o*(t+4)):[...[e+4+t,i-4].filter(r=>r<=n&&r>=t),Math.max(Math.min((i+e+t)/2,n),Math.min(t,n))]}function CS({left:i,right:e,size:t},n){let[s,r]=e-i<t?[e+t,i]:[e+t/2,i+t],o=Math.min(s,n),a=Math.max(r,t),l=t/6;return o<a?[]:Array.from({length:Math.max(Math.floor((o-a)/l),0)+1},(c,h)=>o-h*l)}var RS={light:["#0072B2","#D55E00","#009E73","#AA4499","#8A6D00","#3A3A3A"],dark:["#56B4E9","#F28E4B","#2FC7A0","#E39AC8","#F0E442","#D0D0D0"]},h0=[[],[7,4],[2,3]],Xn=(i,e)=>{let t=RS[e];return{colour:t[i%t.length],dash:[...h0[Math.floor(i/t.length)%h0.length]]}},bs=i=>i==="dark"?{back:"#14191d",axis:"#9fb0bb",grid:"#2b343b",text:"#dbe5ec",limit:"#ffb347",violated:"#ff6b57",unbinding:"#b89a6a",mode:"#53616b"}:{back:"#ffffff",axis:"#50616c",grid:"#e3e8ec",text:"#24323b",limit:"#9a5b00",violated:"#c61a1a",unbinding:"#a98a5c",mode:"#b9c4cc"};var u0=54,PS=10,d0=8,IS=34,Ea=3.5,pc=(i,e)=>({left:u0,top:d0,width:i-u0-PS,height:e-d0-IS});function p0(i,e,t,n,s){let r=pc(t,n),o=bs(s),{x:a,y:l}=e,c=_=>r.left+js(a,_)*r.width,h=_=>r.top+(1-js(l,_))*r.height;i.clearRect(0,0,t,n),i.font="11px system-ui, sans-serif",i.save(),i.beginPath(),i.rect(r.left,r.top,r.width,r.height),i.clip(),i.imageSmoothingEnabled=!1;let[u,d]=[r.width/(a.points-1),r.height/(l.points-1)];i.drawImage(NS(e),r.left-u/2,r.top-d/2,r.width+u,r.height+d);for(let _ of e.feasible.boundary)i.beginPath(),_.forEach(([m,g],x)=>x?i.lineTo(c(m),h(g)):i.moveTo(c(m),h(g))),i.strokeStyle=o.text,i.lineWidth=2,i.stroke();i.restore(),US(i,r,e,o.axis,o.text);let f=e.marks.flatMap(_=>_.of_this_model&&_.x!==null&&_.y!==null&&f0(a,_.x)&&f0(l,_.y)?[{mark:_,at:[c(_.x),h(_.y)]}]:[]);for(let{mark:_,at:m}of f)i.beginPath(),i.arc(...m,Ea,0,7),i.fillStyle=_.kept===void 0?o.axis:_.kept?o.text:_.decides?o.violated:o.unbinding,i.fill(),i.strokeStyle=s==="dark"?"#000":"#fff",i.lineWidth=1,i.stroke();let p=f.map(({at:[_,m]})=>[_-Ea,m-Ea,_+Ea,m+Ea]);for(let{mark:_,at:m}of f)FS(i,_.case||"base model",m,r,p,s);e.best&&kS(i,[c(e.best.x),h(e.best.y)],o.text,s)}var f0=({from:i,to:e},t)=>t>=i&&t<=e,LS=255,DS=71;function NS({x:i,y:e,grid:t,colours:n}){let s=document.createElement("canvas");[s.width,s.height]=[i.points,e.points];let r=s.getContext("2d"),o=r.createImageData(i.points,e.points),a=new Map(n.map(({governing:l,colour:c})=>[l,OS(c)]));return t.governing.forEach((l,c)=>{let h=e.points-1-Math.floor(c/i.points),u=4*(h*i.points+c%i.points),d=t.margin[c]??null,f=l==="none"||d!==null&&d>=1,[p,_,m]=a.get(l==="no model"?"not computed":l);o.data.set([p,_,m,f?DS:LS],u)}),r.putImageData(o,0,0),s}var OS=i=>[1,3,5].map(e=>parseInt(i.slice(e,e+2),16));function US(i,e,{x:t,y:n},s,r){let{left:o,top:a,width:l,height:c}=e;i.strokeStyle=s,i.lineWidth=1,i.strokeRect(o+.5,a+.5,l-1,c-1),i.fillStyle=r,i.textAlign="center";let h=-1/0;for(let d of Xd(t,l/55)){let f=o+js(t,d)*l,p=He(d,4);i.fillRect(f,a+c,1,4),!(f-h<i.measureText(p).width+8)&&(h=f,i.fillText(p,Math.min(Math.max(f,o+6),o+l-6),a+c+15))}i.textAlign="right";let u=1/0;for(let d of Xd(n,c/28)){let f=a+(1-js(n,d))*c;i.fillRect(o-4,f,4,1),!(u-f<13)&&(u=f,i.fillText(He(d,4),o-7,Math.min(f+4,a+c)))}i.textAlign="center",i.fillText(Ta(t),o+l/2,a+c+29),i.save(),i.translate(11,a+c/2),i.rotate(-Math.PI/2),i.fillText(Ta(n),0,0),i.restore()}var Ta=({name:i,unit:e})=>e?`${i} [${e}]`:i;function FS(i,e,[t,n],s,r,o){let a=i.measureText(e).width,l=[t+6,t-6-a].filter(h=>h>=s.left&&h+a<=s.left+s.width),c=[n-5,n+14].flatMap(h=>l.map(u=>[u,h-10,u+a,h+2])).find(h=>h[1]>=s.top&&!r.some(u=>ro(h,u)));c&&(r.push(c),i.textAlign="left",i.lineWidth=3,i.strokeStyle=bs(o).back,i.fillStyle=bs(o).text,i.strokeText(e,c[0],c[3]-2),i.fillText(e,c[0],c[3]-2))}function kS(i,[e,t],n,s){i.beginPath();for(let r=0;r<10;r++){let o=r%2?3.2:8,a=Math.PI*(r/5-.5);i.lineTo(e+o*Math.cos(a),t+o*Math.sin(a))}i.closePath(),i.fillStyle=n,i.fill(),i.lineWidth=1,i.strokeStyle=s==="dark"?"#000":"#fff",i.stroke()}var jd=class extends vn{constructor(){super();this.drawn=[];this.watcher=null;this.axes=t=>[new wa(this.app,t.x,t,"x"),new wa(this.app,t.y,t,"y")];[this.pair,this.spoken]=[0,""]}static{this.properties={...vn.properties,pair:{state:!0},spoken:{state:!0}}}connectedCallback(){super.connectedCallback(),this.unsubscribe.push(this.app.beside.subscribe(()=>this.requestUpdate()))}render(){let{beside:t}=this.app,n=this.maps,s=this.map,r=t.isRunning("map");if(!s)return re`<p class="hint">${t.failure("map")||(t.takesLong("map")?this.app.engine.oneAtATime?"The kernel answers nothing else while it computes the map.":"The map takes longer than a second.":"Computing …")}</p>${this.computeButton()}`;let o=this.point(s),a=this.axes(s),l=`Map of ${Ta(s.x)} and ${Ta(s.y)}`;return re`<div class="bar">${n.length>1?re`<select aria-label="Pair of numbers" @change=${c=>{this.pair=Number(c.target.value)}}>
          ${n.map((c,h)=>re`<option value=${h} ?selected=${h===this.pair}>${c.y.name} over ${c.x.name}</option>`)}</select>`:Re}
        <span>${s.kept} of ${s.designs} designs meet all rules</span>${t.isOld("map")?re`<span class="old" title="computed for other numbers">…</span>`:Re}
        ${s.best?re`<button title="Move the design to the largest margin of the map" @click=${()=>this.set(s,s.best.x,s.best.y)}>★ best</button>`:Re}${r?Re:this.computeButton()}</div>
      <div class="map" tabindex="0" role="application" aria-label="${l}. Arrow keys move the design, with Shift far." @keydown=${c=>this.key(c,s)}
           @pointerdown=${c=>this.pressed(c,s)} @pointermove=${c=>this.moved(c,s)} @pointerup=${()=>this.app.state.dropped()}>
        <canvas></canvas><span class="design" ?hidden=${!o} title="the design on the page"></span></div>
      <p class="hint">${o?this.words(s,o):`${a.map(c=>c.value===null?c.paths.join(", "):"").filter(Boolean).join(" and ")} is not in the file: click in the map to set it.`}</p>
      <ul class="rules">${s.colours.map(({colour:c,words:h})=>re`<li><svg viewBox="0 0 12 12" aria-hidden="true"><rect width="12" height="12" fill=${c}></rect></svg>${h}</li>`)}
        <li class="note">colour: the rule with the least margin; light: all are met; ★ largest margin${s.marks.some(c=>c.kept===!1)?`; ●: cases, red if they violate a rule${s.marks.some(c=>!c.decides&&c.kept===!1)?", ochre where that is not binding":""}`:""}</li></ul>
      <p class="hidden" role="status" aria-live="polite">${this.spoken}</p>`}updated(){let{map:t}=this,n=this.querySelector(".map"),{theme:s}=this.app.display;if(!t||!n)return;this.watcher||(this.watcher=new ResizeObserver(()=>{this.drawn=[],this.requestUpdate()}),this.watcher.observe(n));let{clientWidth:r,clientHeight:o}=n,a=n.querySelector("canvas"),l=[t,r,o,s,devicePixelRatio];if(r<120||o<80)return;if(l.some((d,f)=>d!==this.drawn[f])){this.drawn=l,[a.width,a.height]=[r*devicePixelRatio,o*devicePixelRatio];let d=a.getContext("2d");d.scale(devicePixelRatio,devicePixelRatio),p0(d,t,r,o,s)}let c=this.point(t),h=n.querySelector(".design"),u=pc(r,o);c&&Object.assign(h.style,{left:`${u.left+c[0]*u.width}px`,top:`${u.top+(1-c[1])*u.height}px`})}disconnectedCallback(){super.disconnectedCallback(),this.watcher?.disconnect(),this.watcher=null}get maps(){let t=this.app.beside.result("map");return t?"pairs"in t?t.pairs:[t]:[]}get map(){return this.maps[this.pair]??this.maps[0]??null}computeButton(){let{beside:t}=this.app;return t.takesLong("map")?re`<button @click=${()=>t.waitFor("map")}>Compute the map</button>`:Re}point(t){let[n,s]=this.axes(t).map(o=>o.value),r=[n==null?NaN:js(t.x,n),s==null?NaN:js(t.y,s)];return r.every(o=>o>=-1e-9&&o<=1+1e-9)?r:null}words(t,[n,s]){let r=this.axes(t),[o,a]=[Math.round(n*(t.x.points-1)),Math.round(s*(t.y.points-1))],l=a*t.x.points+o,c=(f,p)=>`${t.x.name} ${`${He(f,4)} ${t.x.unit}`.trim()}, ${t.y.name} ${`${He(p,4)} ${t.y.unit}`.trim()}`,h=t.grid.margin[l],u=t.grid.governing[l],d=typeof u=="number"?`margin ${He(h,4)}, by ${t.colours.find(f=>f.governing===u).words}`:u==="none"?"nothing limits it":"no result";return`${c(r[0].value,r[1].value)}. Nearest design of the map, ${c(r[0].at(o/(t.x.points-1)),r[1].at(a/(t.y.points-1)))}: ${d}`}set(t,n,s,r=!1){let[o,a]=this.axes(t);this.app.state.set({...o.settings(n),...a.settings(s)},r)}to(t,n,s,r){let[o,a]=this.axes(t),l=c=>Math.min(Math.max(c,0),1);this.set(t,o.at(l(n)),a.at(l(s)),r)}pressed(t,n){if(t.button!==0)return;let s=t.currentTarget,[r,o]=m0(t,s);r<-.02||r>1.02||o<-.02||o>1.02||(s.setPointerCapture(t.pointerId),s.focus(),this.to(n,r,o,!0),t.preventDefault())}moved(t,n){let s=t.currentTarget;s.hasPointerCapture(t.pointerId)&&this.to(n,...m0(t,s),!0)}key(t,n){let s=t.shiftKey?.1:.01,[r,o]=this.point(n)??[.5,.5],a={ArrowLeft:[-s,0],ArrowRight:[s,0],ArrowUp:[0,s],ArrowDown:[0,-s]},l=a[t.key];if(!l||t.ctrlKey||t.metaKey||t.altKey)return;this.to(n,r+l[0],o+l[1],!1);let c=this.point(n);c&&(this.spoken=this.words(n,c)),t.preventDefault()}};function m0(i,e){let{left:t,top:n}=e.getBoundingClientRect(),s=pc(e.clientWidth,e.clientHeight);return[(i.clientX-t-s.left)/s.width,1-(i.clientY-n-s.top)/s.height]}ue.define("map-panel",jd);var BS=/ \((?:free|grows)\)$/,zS=/ \([^(),]+,[^(),]+,[^(),]+\)/;function g0(i){let[e=""]=BS.exec(i)??[];return i.slice(0,i.length-e.length).replace("mostly ","≈ ").replace("translation ","").replace("rotation ","").replace(/ through .*/,"").replace(zS," skew axis")+e}function gc(i,e,t,n){let s=e?n.byPath.get(["cases",e,...i].join("\0")):void 0,r=s??n.byPath.get(i.join("\0"));if(!r)return null;let o=i.some((c,h)=>n.byPath.get(i.slice(0,h+1).join("\0"))?.kind==="array"),a=s||o?null:Oi(i),l=Dn(a&&t.settings.get(a)||r.raw);return l&&{entry:r,path:a,...l}}var _c=i=>Number(i.toPrecision(3));function Aa(i,{entry:e,path:t,unit:n},s,r=!1){if(t)return i.set({[t]:ys(s,n)},r);r||i.replaceNumber(e,ys(s,n))}var mc=class{constructor(){this.factors=new Map}allowed({place:e,allowed:t},{value:n,unit:s},r){let o=[...e,s].join("\0");r&&t!==null&&this.factors.set(o,t/n);let a=this.factors.get(o);return a===void 0?null:n*a}};var _0={orders:"orders",random:"random excitations",time:"forces over time"};function yc(i){let{asker:e,index:t}=i,n=[...t.byPath.values()].filter(a=>a.path[0]==="excitations"&&a.path.length===3&&a.path[2]==="type").map(a=>a.raw.slice(1,-1)),s=Object.keys(_0).filter(a=>n.includes(a)).map(a=>_0[a]),r=e.missing("curves");return!r.includes("no harmonic excitation in the model")||!s.length?r:`Curves over frequency belong to a harmonic excitation; this machine has ${s.length>1?`${s.slice(0,-1).join(", ")} and ${s.at(-1)}`:s[0]}.${ei(i)?" What is required of it is judged in the table Requirements.":""}`}var oo=re`<p class="outdated-note">of the last state without errors</p>`;function xc(i,{display:e},t,n="a number"){let s=Math.abs(Number(i.value.trim().match(/^[-+]?[\d.]+e\+?\d+/i)?.[0]))===1/0;e.set({notice:s?`"${i.value}" is too large a number; it stays ${t}.`:`"${i.value}" is not ${n}, perhaps with a unit; it stays ${t}.`}),i.value=t}var y0={modes:"Modes",requirements:"Requirements",mounts:"Mounts",peaks:"Peaks",map:"Map"},VS={modes:"modes",requirements:"verdict",mounts:"check",peaks:"curves",map:"map"},GS=["x","y","z","θx","θy","θz"],Kd=i=>i.engine.isLive&&i.index.byPath.has("analyses\0map");function Qd(i){let{table:e}=i.display,t=ei(i)?"requirements":Kd(i)?"map":"modes";return e&&(e!=="map"||Kd(i))?e:t}var Jd=class extends vn{constructor(){super(...arguments);this.inView=null;this.rows=[];this.judged=t=>t.unit!=="rad/s"&&t.shown_value?t.shown_value:this.value(t.value,t.unit)}render(){let{app:t}=this,n=Qd(t),s={modes:()=>this.modes(),requirements:()=>this.requirements(),mounts:()=>this.mounts(),peaks:()=>this.peaks(),map:()=>re`<map-panel .app=${t}></map-panel>`},r=Object.keys(y0).filter(a=>a!=="map"||Kd(t)),o=n==="map"?t.beside.isOld("map")&&t.asker.hasErrors:t.asker.isOutdated(VS[n]);return re`<div class="tabs" role="tablist" aria-label="Tables">${r.map(a=>re`<button role="tab" id="tab-${a}" aria-controls="table-panel" aria-selected=${a===n} @click=${()=>this.choose(a)}>${y0[a]}</button>`)}</div>
      <div class="scroll table ${o?"outdated":""}" role="tabpanel" id="table-panel" aria-labelledby="tab-${n}" tabindex="0" @scroll=${this.scrolled}>${o?oo:Re}${s[n]()}</div>`}choose(t){this.app.display.set({table:t}),this.app.beside.rest()}modes(){let{asker:t,display:n}=this.app,s=t.result("modes"),r=t.result("roots");if(!s)return this.missing("modes");let o=s.bodies.length===1,a=s.kinetic_energy_share_words??"shares of the kinetic energy";return re`<table><thead><tr><th scope="col">Mode</th><th scope="col">${n.frequencyUnit}</th><th scope="col" title="damping ratio of the nearest root">ζ</th><th scope="col" class="words">motion</th>
      ${o?GS.map(l=>re`<th scope="col" title=${a}>${l}</th>`):re`<th scope="col">kinetic energy</th>`}</tr></thead><tbody>
      ${this.modesInView(s).map(l=>{let c=n.shown.kind==="mode"&&n.shown.number===l.number,h=r?.roots.find(u=>u.nearest_mode===l.number&&u.eigenvalue[1]>0);return re`<tr aria-selected=${c} class=${c?"chosen":""} @click=${()=>n.set({shown:{kind:"mode",number:l.number}})}>
          <th scope="row"><button class="link" aria-label="Show mode ${l.number}">${l.number}</button></th><td>${is(l.angular_frequency,n.frequencyUnit).split(" ")[0]}</td>
          <td>${h?`${He(100*h.damping_ratio,3)} %`:r?"–":re`<span class="old">…</span>`}</td><td class="words" title=${l.name}>${g0(l.name)}</td>
          ${o?l.kinetic_energy_share.map(u=>re`<td class=${Zd(u)?"share coupled":"share"} title=${Zd(u)?a:""}>${Math.abs(u)>=.005?Math.round(100*u):""}</td>`):re`<td class="words">${WS(s,l)}</td>`}</tr>`})}</tbody></table>${o?re`<p class="hint">x … θz in %: ${s.modes.some(l=>l.kinetic_energy_share.some(Zd))?a:"shares of the kinetic energy"}.</p>`:Re}${this.energies(s)}`}modesInView({modes:t}){let n=this.numbersMove&&this.inView&&this.rows.length===t.length;return this.rows=n?t.map((s,r)=>this.inView.has(r)?s:this.rows[r]):t,this.rows}get numbersMove(){return this.app.asker.isOld("curves")&&!this.app.asker.hasErrors}updated(){!this.numbersMove&&this.rows.length>x0&&this.look()}look(){let t=this.querySelector("#table-panel"),{top:n,bottom:s}=t.getBoundingClientRect();this.inView=new Set([...t.querySelectorAll("tbody tr")].flatMap((r,o)=>{let a=r.getBoundingClientRect();return a.bottom>=n&&a.top<=s?[o]:[]}))}scrolled(){this.rows.length<=x0||(this.look(),this.requestUpdate())}energies(t){let{shown:n}=this.app.display,s=n.kind==="mode"?t.modes.find(o=>o.number===n.number):void 0;if(!s)return Re;let r=t.elements.map((o,a)=>({name:o,share:s.strain_energy_share?.[a]??0})).filter(o=>Math.abs(o.share)>=.005).sort((o,a)=>a.share-o.share);return re`<p class="hint">Mode ${s.number}: ${s.name}. Strain energy: ${r.map(o=>`${o.name} ${He(100*o.share,3)} %`).join(", ")||"–"}.</p>`}requirements(){let{asker:t,state:n}=this.app,s=t.result("verdict");if(!ei(this.app))return re`<p class="hint">The file has no [requirements], [limits] or limit lines. With them every design is judged here, with its margins.</p>`;if(!s)return this.missing("verdict");let r=s.cases.find(u=>u.case===n.case)??s.cases[0],o=[...r?.requirements??[]].sort((u,d)=>(u.margin??1/0)-(d.margin??1/0)),a=t.isOld("verdict")?re` <span class="old">…</span>`:Re,l=r?.decides!==!1,c=s.cases.length>1,h=o.some(u=>u.place.length);return re`<table class="requirements">${l?Re:re`<caption>The requirements are not binding in this case.</caption>`}<thead><tr><th scope="col">Requirement</th><th scope="col" class="value">value${h?", limit":""}</th><th scope="col" class="margin" title="1: just met; more: met with room">margin</th>${c?re`<th scope="col" class="elsewhere" title="least margin of all other cases">elsewhere</th>`:Re}<th scope="col" class="met">met</th></tr></thead><tbody>
      ${o.map(u=>re`<tr class=${u.judged?u.met?"":l?"violated":"unbinding":"unjudged"}><th scope="row" class="words">${u.shown_requirement??u.requirement}</th><td>${u.judged?this.judged(u):u.reason||"–"}${this.limit(u)}</td>
        <td>${u.margin===null?"–":He(u.margin,3)}${a}</td>${c?re`<td>${this.elsewhere(s,u)}</td>`:Re}<td>${u.judged?u.met?"✓":l?"✗":"(✗)":"–"}<span class="hidden">${u.met?"yes":l?"no":"no, not binding"}</span></td></tr>`)}</tbody></table>`}limit(t){let{state:n,index:s}=this.app,r=t.place.length?gc(t.place,n.case,n.design,s):null;if(!r)return"";let o=`${He(r.value,6)} ${r.unit}`.trim();return re`<input class="number" aria-label="Limit: ${t.shown_requirement??t.requirement}" .value=${o} @change=${a=>{let l=a.target,c=Dn(l.value.replaceAll("−","-").replace(",","."));c&&c.value>0?Aa(n,{...r,unit:c.unit||r.unit},c.value):xc(l,this.app,o,"a number above 0")}}>`}elsewhere({cases:t},{kind:n,subject:s,requirement:r}){let o=t.filter(h=>h.case!==this.app.state.case).flatMap(h=>h.requirements.filter(u=>u.kind===n&&u.subject===s&&u.requirement===r&&u.judged&&u.margin!==null).map(u=>({in:h.case,binding:h.decides,r:u}))),a=o.filter(h=>h.binding&&!h.r.met),c=[...a.length?a:o].sort((h,u)=>h.r.margin-u.r.margin||Number(u.binding)-Number(h.binding))[0];return c?re`<span class=${v0(c.r,c.binding)}>${He(c.r.margin,3)} ${c.in||"base model"}${c.r.met||c.binding?"":", not binding"}</span>`:"–"}mounts(){let{asker:t,state:n}=this.app,s=t.result("check"),r=s?.mounts??[],o=r.filter(h=>h.case===n.case),a=o.length?o:r.filter(h=>h.case===""),l=t.result("verdict")?.cases.find(h=>h.case===n.case),c=(l?.requirements??[]).filter(h=>h.kind==="mount_load"&&h.judged);return s?a.length?re`<table><caption>At rest under gravity</caption><thead><tr><th scope="col">Mount</th><th scope="col">compression</th><th scope="col">across</th><th scope="col">deflection</th>${c.length?re`<th scope="col" title="of its load range in the catalogue; 1: just met">margin of load${l.decides?"":", not binding"}</th>`:Re}</tr></thead><tbody>
      ${a.map(h=>{let u=n.selection?.kind==="element"&&n.selection.name===h.element;return re`<tr class=${u?"chosen":""} @click=${()=>n.select({kind:"element",name:h.element})}><th scope="row"><button class="link">${h.element}</button></th>
          <td>${ns(h.compression,"N")}</td><td>${ns(h.across,"N")}</td><td>${ns(h.deflection,"m")}</td>
          ${c.length?re`<td>${c.filter(d=>d.subject===h.element).map(d=>re`<span class=${v0(d,l.decides)}>${d.margin===null?"–":He(d.margin,3)}</span>`)}</td>`:Re}</tr>`})}</tbody></table>`:re`<p class="hint">No load at rest: the file has no gravity, or no mount that carries a load.</p>`:this.missing("check")}peaks(){let{asker:t,display:n,engine:s}=this.app,r=t.result("curves");if(!r)return re`<p class="hint">${yc(this.app)}</p>`;let o=new Map(r.results.map(c=>[c.name,c])),a=r.peaks.filter(c=>c.angular_frequency>=r.band[0]&&c.angular_frequency<=r.band[1]),l=({angular_frequency:c})=>{n.set({cursor:c,...s.isLive?{shown:{kind:"frequency",omega:c}}:{}}),t.again()};return re`<table><thead><tr><th scope="col">Result</th><th scope="col">${n.frequencyUnit}</th><th scope="col">amplitude</th><th scope="col">phase</th></tr></thead><tbody>
      ${a.map(c=>re`<tr @click=${()=>l(c)}>
        <th scope="row">${s.isLive?re`<button class="link" aria-label="Show the motion at this peak of ${c.result}">${c.result}</button>`:c.result}</th><td>${is(c.angular_frequency,n.frequencyUnit).split(" ")[0]}</td>
        <td>${c.amplitude===null?"∞":HS(c.amplitude,o.get(c.result))}</td><td>${c.phase==null?"–":`${He(Math.round(c.phase*18e6/Math.PI)/1e5,3)}°`}</td></tr>`)}</tbody></table>${t.notes("curves").map(c=>re`<p class="hint">${c}</p>`)}`}value(t,n){return n==="rad/s"?is(t,this.app.display.frequencyUnit,3):n==="1"?He(t,3):ns(t,n,3)}missing(t){return re`<p class="hint">${this.app.asker.missing(t)}</p>`}},x0=12,Zd=i=>i<=-.005||i>=1.005,v0=({met:i},e)=>i?"":e?"bad":"minor";function HS(i,e){let t=Jl(i,e?.unit??"",e);return`${He(i*t.factor)} ${t.unit}`.trim()}function WS(i,e){return i.bodies.map((n,s)=>({name:n,share:e.body_kinetic_energy_share[s]})).filter(n=>n.share>=.05).sort((n,s)=>s.share-n.share).slice(0,3).map(n=>`${n.name} ${Math.round(100*n.share)} %`).join(", ")}ue.define("result-tables",Jd);function b0(i,{hasSomethingToJudge:e,hasSteady:t,bodies:n}){let{shown:s}=i,r=[{want:{command:"scene"}},...$S(i,n),...qS(i)];return s.kind==="frequency"&&r.push({want:{command:"shapes"},settings:[`analyses.shapes.at = ["${s.omega} rad/s"]`]}),r.push({want:{command:"roots"},slow:!i.damped},{want:{command:"check"},slow:!0}),e&&r.push({want:{command:"verdict"},slow:!0}),t&&r.push({want:{command:"steady",...s.kind==="steady"?{keys:{at:`${s.omega} rad/s`}}:{}},slow:!0}),r}function $S({shown:i},e){let t={want:{command:"modes"}};return e<2?[t]:[{want:{command:"modes",keys:{"shapes-of":i.kind==="mode"?i.number:1}},as:Cd("modes")},{...t,after:!0}]}function qS({drawn:i,quantity:e}){let t=e?{quantity:e}:{},n={want:{command:"curves",keys:t}};return i.length?[{want:{command:"curves",keys:{...t,draft:!0,of:i}},as:"draft"},{...n,exact:!0}]:[n]}var XS=1e3;function S0(i){return i.state.design.text?[...e0(i),...Qd(i)==="map"?[YS(i)]:[]]:[]}function YS(i){let{change:e}=i.state,t=jS(i),n=i.engine.oneAtATime?0:XS,s=e.settings.filter(r=>!t.has(r.slice(0,r.indexOf(" = "))));return{key:"map",change:{...e,settings:s},want:{command:"map"},patience:n}}function jS({index:i}){let e=n=>i.byPath.get(n.join("\0"))?.raw.replace(/^["']|["']$/g,""),t=["x","y"].map(n=>e(["analyses","map",n,"parameter"])).filter(n=>n!==void 0);return new Set(t.flatMap(n=>yr(n).length>1?[n]:r0(n,i).map(s=>s.path)))}var ZS=1e3,KS=3;function M0(i,e,t=i,n=null){let s=new hc,r=new Zl,o=()=>s.design.text?b0(r,{hasSomethingToJudge:ei(u),hasSteady:u.index.byPath.has("analyses\0steady"),bodies:c.result("scene")?.bodies.length??0}):[],a=new jl(t,()=>S0(u)),l={ask(...d){return i.oneAtATime||a.yield(),i.ask(...d)}},c=new ga(l,s,o),h=n&&new ga(n,s,()=>Bd(u),ZS,KS),u=new cc(i,e,s,r,c,a,h);return c.subscribe(()=>{h?.trouble&&!c.trouble&&h.afresh()}),s.subscribe(a.rest),c.subscribe(a.rest),u}var w0=i=>(...e)=>({_$litDirective$:i,values:e}),vc=class{constructor(e){}get _$AU(){return this._$AM._$AU}_$AT(e,t,n){this._$Ct=e,this._$AM=t,this._$Ci=n}_$AS(e,t){return this.update(e,t)}update(e,t){return this.render(...t)}};var{I:lD}=Hg;var JS={},E0=(i,e=JS)=>i._$AH=e;var T0=w0(class extends vc{constructor(){super(...arguments),this.key=Re}render(i,e){return this.key=i,e}update(i,[e,t]){return e!==this.key&&(E0(i),this.key=e),t}});var QS={rms:"the root mean square under the random excitations",largest:"the largest value over time",static:"the value at rest",band_line:"the levels in bands of frequencies, of which no curve is drawn"};function R0(i,e,t){let n=[],s=[];for(let r of t){let{kind:o,subject:a,unit:l,speed:c,band:h,place:u,order:d,excitations:f,level:p=null}=r,_=i.results.find(C=>C.name===a),m=QS[o];if(_&&m&&s.push({words:A0(r),why:`it limits ${m}`}),!u.length||o!=="amplitude"&&o!=="operation"&&o!=="steady")continue;let g=i.models[e]?.excitations??[],x=_?_.unit!==l?C0(l,_.unit):o==="operation"&&p!==(_.level??null)?`it is judged ${p??"without a level"}, of all orders together, and the axis is ${_.level??"without a level"}`:d!==null?`it holds for order ${d} of the shaft alone`:o==="amplitude"&&f.length&&!tM(f,g)?`it holds under ${f.join(", ")} alone`:"":`no curve of ${a} is drawn`;x?s.push({words:o==="operation"?A0(r):r.shown_requirement??r.requirement,why:x}):n.push({requirement:eM(r,_.level_factor),result:a,from:(c??h)?.[0]??0,to:(c??h)?.[1]??1/0,isOfCurve:c===null&&o!=="steady"})}for(let r of i.lines??[]){let o=i.results.find(a=>a.name===r.result);o&&o.unit!==r.unit&&s.push({words:`${r.result} within "${r.name}"`,why:C0(r.unit,o.unit)})}return{drawn:n,not:s}}function P0({cases:i},{lines:e=[]}){let t=i.filter(n=>n.decides).flatMap(n=>n.requirements).find(n=>["amplitude","operation","steady","limit_line","rms","largest"].includes(n.kind));return t?.kind==="limit_line"?e.find(n=>n.result===t.subject)?.unit??null:t?.unit??null}function eM(i,e=1){let t=n=>n===null?null:n/e;return i.kind==="operation"?{...i,allowed:t(i.allowed),value:t(i.value)}:i}var A0=i=>`${i.shown_requirement??i.requirement} (${i.judged?`${i.shown_value?`${i.shown_value}, `:""}margin ${He(i.margin??1/0,3)}`:"not judged"})`,C0=(i,e)=>`it limits the ${no(i)}, the curve is the ${no(e)}`,tM=(i,e)=>i.length===e.length&&i.every(t=>e.includes(t));function L0(i,e,t,n,s,r,o,a){let l=[],c=[],h=hi[r.frequencyUnit];for(let{id:u,line:d,factor:f,movable:p,old:_,binding:m}of i){let g=e.indexOf(d.result),x=Sg(d.rms?"rms":"0-p");if(g<0||d.unit!==n||t.has(d.result))continue;let C=d.angular_frequency.map((M,U)=>[M*h,o(f*d.limit[U]/x)]),b=nM(C,a,r);if(l.push({name:d.result,stroke:g,kind:"limit",points:C}),!b)continue;let A=(d.exceeded??[]).length>0,S=`margin ${He(d.least_margin??1/0,3)}${A&&!m?", not binding":""}${_?" …":""}`,y=p?"moving it moves all its levels by one factor":"its levels are not in this file: it cannot be moved here";c.push({id:u,result:d.result,...b,label:`${d.name} ≤ ${He(b.y)} ${s.unit} · ${S}`,short:`≤ ${He(b.y)} · ${S}`,words:`${d.result} within "${d.name}": ${S}${A?", violated":""}; ${y}`,violated:A,binding:m,movable:p,isOfCurve:!1,isLine:!0,at:null,...Xn(g,r.theme)})}return{overlays:l,handles:c}}function nM(i,[e,t],{logarithmicFrequency:n,logarithmicAmplitude:s,decibel:r}){let[o,a]=I0(n),[l,c]=I0(s&&!r),h=i.slice(1).flatMap(([d,f],p)=>{let[_,m]=i[p],g=Math.max(o(_),o(e)),x=Math.min(o(d),o(t));if(m===null||f===null||!(x>g))return[];if(m===f)return[{length:x-g,from:_,to:d,y:m}];let C=(g+x)/2,b=(C-o(_))/(o(d)-o(_)),A=a(C);return[{length:x-g,from:A,to:A,y:c(l(m)+b*(l(f)-l(m)))}]}),[u]=h.sort((d,f)=>f.length-d.length);return u?{from:u.from,to:u.to,y:u.y}:null}var I0=i=>i?[Math.log,Math.exp]:[e=>e,e=>e];var bc=class{constructor(e,t,n=[...Array(t).keys()]){this.model=e;this.wanted=n;this.out=new Float64Array(2*this.wanted.length);this.parts=e.pieces.map(s=>iM(s,e.delays.length,t,n))}at(e){let{out:t}=this,n=this.parts.find(_=>e<=_.to)??this.parts.at(-1);if(t.fill(0),!n||this.model.undefined_at.includes(e))return t.fill(NaN);let{nodes:s,weights:r,products:o,inverse:a,values:l}=n,c=s.length,h=s.indexOf(e),u=0,d=0;if(h<0)for(let _=0;_<c;_++){let m=a[_]=1/(e-s[_]);u+=r[2*_]*m,d+=r[2*_+1]*m}else[u,d]=[1,0];let f=u*u+d*d,p=this.wanted.length;return this.model.delays.forEach((_,m)=>{let g=Math.cos(e*_),x=-Math.sin(e*_),C=(g*u+x*d)/f,b=(x*u-g*d)/f;for(let A=0;A<p;A++){let S=2*c*(m*p+A),y=0,M=0;if(h<0)for(let U=0,N=S;U<c;U++,N+=2)y+=o[N]*a[U],M+=o[N+1]*a[U];else[y,M]=[l[S+2*h],l[S+2*h+1]];t[2*A]+=C*y-b*M,t[2*A+1]+=C*M+b*y}}),t}};function D0(i,e){return Math.abs(e)<=1e-9*Math.abs(i)?i<0?Math.PI:0:Math.atan2(e,i)}function iM({band:i,nodes:e,weights:t,values:n},s,r,o){let a=e.length,l=new Float64Array(2*a*s*o.length).fill(NaN),c=new Float64Array(l.length);for(let h=0;h<s;h++)o.forEach((u,d)=>l.set(n[h*r+u],2*a*(h*o.length+d)));for(let h=0;h<l.length;h+=2){let u=h%(2*a),[d,f,p,_]=[t[u],t[u+1],l[h],l[h+1]];c[h]=d*p-f*_,c[h+1]=d*_+f*p}return{to:i[1],nodes:Float64Array.from(e),weights:Float64Array.from(t),values:l,products:c,inverse:new Float64Array(a)}}var sM=Array.from({length:9},(i,e)=>10**(-4+.375*e)),rM=.001,oM=5;function ef(i,e,t,n=i.results.map((s,r)=>r)){let[s,r]=i.band,o=s>0?s:r*.001,a=t?o:s,l=[a,r];for(let x=0;x<=e;x++){let C=x/e;l.push(t?o*(r/o)**C:a+(r-a)*C)}let c=new Set(n.map(x=>i.results[x].name)),h=i.peaks.filter(x=>c.has(x.result)).map(x=>x.angular_frequency);for(let x of n)for(let[C]of i.results[x].extrema??[])l.push(C);let u=[...i.natural,...h];l.push(...u);let d=0;for(let x of u.sort((C,b)=>C-b))if(!(x-d<rM*x)){d=x;for(let C of sM)l.push(x*(1-C),x*(1+C))}let f=[...new Set(l)].filter(x=>x>=a&&x<=r).sort((x,C)=>x-C);if(!i.draft)return f;let p=new Set(u),_=1/(oM*e),m=(x,C)=>(t?Math.log(C/x)/Math.log(r/o):(C-x)/(r-a))>_,g=-1/0;return f.filter(x=>{let C=p.has(x)||x===r||g<o||m(g,x);return C&&(g=x),C})}function tf(i,e,t,n=i.results.map((s,r)=>r)){let{results:s}=i,r=i.models[e],o=s.map(()=>[]),a=s.map(()=>[]);if(!r)return{omega:[],amplitude:o,phase:a};let l=n.map(h=>new Map([...s[h].extrema??[],...i.peaks.filter(u=>u.result===s[h].name).map(u=>[u.angular_frequency,u.amplitude])])),c=new bc(r,s.length,n);for(let h of t){let u=c.at(h);for(let d=0;d<n.length;d++){let f=n[d],p=u[2*d],_=u[2*d+1],m=Math.sqrt(p*p+_*_),g=Number.isFinite(m);o[f].push(g?l[d].get(h)??m:null),a[f].push(g&&m>0?D0(p,_)*180/Math.PI:null)}}return{omega:t,amplitude:o,phase:a}}function N0(i,e,t,n,s,r){return i.flatMap(({channels:o})=>o.flatMap(a=>{let l=n.indexOf(a.result);return l<0||a.unit!==t?[]:[{name:a.result,stroke:l,kind:"measured",of:e,points:a.angular_frequency.map((c,h)=>[c*s,r(Math.hypot(...a.measured[h]))])}]}))}function O0(i,e,t,n,s){return i.flatMap(r=>{let o=t.indexOf(r.result),a=l=>r.angular_frequency.map((c,h)=>[c*n,l[h]==null?null:s(l[h])]);return o<0||r.unit!==e?[]:[{name:r.result,stroke:o,kind:"band",points:a(r.low),upper:a(r.high)}]})}function U0(i,e){let t=Sc(i,e),n=Sc({...i,points:i.upper??[]},e);return t&&n&&[t.y,n.y]}function Sc({kind:i,points:e},t){let n=e.findIndex(l=>l[0]>=t),s=e[n],r=e[n-1]??s;if(!r||!s||n===0&&s[0]>t)return null;let o=s[0]>r[0]?(t-r[0])/(s[0]-r[0]):0;if(i==="measured"){let[l,c]=o<.5?r:s;return c===null?null:{x:l,y:c}}let a=o===0?r[1]:o===1?s[1]:r[1]===null||s[1]===null?null:r[1]+o*(s[1]-r[1]);return a===null?null:{x:t,y:a}}function F0(i,e,t,n,s){if(i.over!=="frequency")return[];let r=[];return i.results.forEach(({name:o,unit:a},l)=>{let c=t.indexOf(o);if(c<0||a!==e)return;let h=u=>[u.angular_frequency*n,s((u.results[l].largest-u.results[l].smallest)/2)];for(let u of[i,...i.further??[]]){r.push(...aM(u.points,h).map(({stable:d,points:f})=>({name:o,stroke:c,kind:d?"stable":"unstable",points:f})));for(let{point:d,lands:f}of u.folds)f&&r.push({name:o,stroke:c,kind:"jump",points:[h(d),h(f)]})}}),r}function k0(i){let e=new Map;for(let{kind:t,name:n,stroke:s,points:r}of i)if(t==="stable")for(let[o,a]of r)a!==null&&a>(e.get(n)?.y??-1/0)&&e.set(n,{x:o,y:a,stroke:s});return[...e.values()]}function aM(i,e){let t=[];return i.forEach((n,s)=>{let r=t.at(-1),o=n.stable===!0;r?.stable===o?r.points.push(e(n)):t.push({stable:o,points:s>0?[e(i[s-1]),e(n)]:[e(n)]})}),t}function B0(i,e,t,n,s){return i?.over!=="frequency"?[]:i.results.flatMap((r,o)=>{if(r.unit!==e||!t.includes(r.name))return[];let a=l=>({x:l.angular_frequency*n,y:s((l.results[o].largest-l.results[o].smallest)/2)??NaN,stable:l.stable});return[{name:r.name,branches:[i,...i.further??[]].map(l=>l.points.map(a))}]})}function z0({branches:i},e){let t=new Set;for(let n of i)for(let s=1;s<n.length;s++){let[r,o]=[n[s-1],n[s]];Math.min(r.x,o.x)<=e&&e<=Math.max(r.x,o.x)&&t.add(Math.abs(r.x-e)<=Math.abs(o.x-e)?r:o)}return[...t].filter(n=>!Number.isNaN(n.y)).sort((n,s)=>s.y-n.y)}var Ca=({stable:i})=>i===null?"of uncertain stability":i?"stable":"unstable";var V0=420,Mc=({results:i,vanishing:e=[]})=>[...new Set(i.filter(t=>!e.includes(t.name)).map(t=>t.unit))];function G0(i,e,t,n=null,s=[],r=!0,o=[]){let a=hi[t.frequencyUnit],l=i.results.map((A,S)=>S).filter(A=>i.results[A].unit===e.unit&&!i.vanishing?.includes(i.results[A].name)),c=l.filter(A=>!e.hidden.has(i.results[A].name)),h=ef(i,V0,t.logarithmicFrequency,c),u=tf(i,e.model,h,c),d=c.reduce((A,S)=>u.amplitude[S].reduce((y,M)=>Math.max(y,M??0),A),0),f=i.results[l[0]??-1],p=t.decibel?{factor:f?.level_factor??1,unit:`${e.unit} ${f?.level??""}`.trim()}:Jl(d,e.unit,f),_=l.map(A=>i.results[A].name),m=A=>Ra(A,p,t),g=c.map(A=>{let{name:S}=i.results[A],y=i.peaks.filter(M=>M.result===S);return{name:S,stroke:l.indexOf(A),amplitude:u.amplitude[A].map(m),phase:u.phase[A],unbounded:y.filter(M=>M.unbounded).map(M=>M.angular_frequency*a),peaks:y.filter(M=>M.amplitude!==null&&M.amplitude>1e-4*d).map(M=>({x:M.angular_frequency*a,y:m(M.amplitude)}))}}),x=O0(o,e.unit,_,a,m).filter(A=>!e.hidden.has(A.name)),C=n?F0(n,e.unit,_,a,m).filter(A=>!e.hidden.has(A.name)):[],b=B0(n,e.unit,_.filter(A=>!e.hidden.has(A)),a,m);for(let A of i.lines??[]){let S=_.indexOf(A.result);if(S<0||A.unit!==e.unit||e.hidden.has(A.result))continue;let y=u.amplitude[i.results.findIndex(M=>M.name===A.result)]??[];for(let[M,U]of A.exceeded??[])C.push({name:A.result,stroke:S,kind:r?"violated":"unbinding",points:h.flatMap((N,L)=>N>=M&&N<=U?[[N*a,m(y[L]??null)]]:[])})}for(let A of s)A.curves&&C.push(...hM(A.curves,A,e,t,_,m)),A.measured&&C.push(...N0(A.measured,A.key,e.unit,_,a,m).filter(S=>!e.hidden.has(S.name)));return{overlays:[...x,...C],limits:[],steady:b,x:h.map(A=>A*a),curves:g,natural:i.natural.map(A=>A*a),scale:p,cursor:t.cursor===null?null:t.cursor*a}}function Ra(i,{factor:e},{decibel:t,logarithmicAmplitude:n}){return i===null||!(i>0||!t&&!n)?null:t?20*Math.log10(i*e):i*e}var H0=(i,{factor:e},{decibel:t})=>(t?10**(i/20):i)/e;function W0(i,e,t,n,s){let r=hi[s.frequencyUnit];return i.flatMap(({limit:{requirement:o,result:a,from:l,to:c,isOfCurve:h},allowed:u,written:d,movable:f,old:p,binding:_},m)=>{let g=e.indexOf(a),x=Ra(u,n,s);if(g<0||t.has(a)||x===null)return[];let C=!h&&o.value!==null?Ra(o.value,n,s):null,b=o.judged&&!o.met,A=o.kind==="steady",S=o.judged?o.margin===null?"nothing limits it":`margin ${He(o.margin,3)}${b&&!_?", not binding":""}`:"not judged",y=M=>`${A?"steady ":""}≤ ${M} · ${S}${p?" …":""}`;return[{id:`${m} ${o.place.join(".")}`,result:a,from:l*r,to:c*r,y:x,label:y(lM(d,x,n,s)),short:y(cM(d,o.level??"",x,n,s)),violated:b,binding:_,movable:f,...Xn(g,s.theme),words:`${o.shown_requirement??o.requirement}: ${S}${b?", violated":""}${A?"; square: the largest deviation of the steady motions from rest":""}`,isOfCurve:h,at:C!==null?{x:(A?o.angular_frequency??l:(l+c)/2)*r,y:C}:null}]})}function lM(i,e,{unit:t},{decibel:n}){let s=`${He(e)} ${t}`;return n||i===s?i:s.startsWith(`${i} `)?s:`${i} = ${s}`}function cM(i,e,t,{unit:n},{decibel:s}){let r=Dn(i);if(s)return i;if(!r?.unit)return He(t);let o=/(0-p|rms|p-p)$/.test(r.unit)||!e?r.unit:`${r.unit} ${e}`;return He(r.value)+(o===n?"":` ${o}`)}function hM(i,{key:e,dash:t},n,s,r,o){let a=ef(i,V0,s.logarithmicFrequency),l=i.results.map((h,u)=>u).filter(h=>i.results[h].unit===n.unit&&r.includes(i.results[h].name)&&!n.hidden.has(i.results[h].name)),c=tf(i,n.model,a,l);return l.map(h=>{let{name:u}=i.results[h];return{name:u,stroke:r.indexOf(u),kind:"compared",of:e,dash:t,points:a.map((d,f)=>[d*hi[s.frequencyUnit],o(c.amplitude[h][f])])}})}var uM="uplot",dM="u-hz",fM="u-vt",pM="u-title",mM="u-wrap",gM="u-under",_M="u-over",yM="u-axis",Rr="u-off",xM="u-select",vM="u-cursor-x",bM="u-cursor-y",SM="u-cursor-pt",MM="u-legend",wM="u-live",EM="u-inline",TM="u-series",AM="u-marker",$0="u-label",CM="u-value",Ia="width",La="height";var q0="bottom",ao="left",nf="right",vf="#000",X0=vf+"0",sf="mousemove",Y0="mousedown",rf="mouseup",j0="mouseenter",Z0="mouseleave",K0="dblclick",RM="resize",PM="scroll",J0="change",Cc="dppxchange",bf="--",mo=typeof window<"u",hf=mo?document:null,co=mo?window:null,IM=mo?navigator:null,Rt,wc;function uf(){let i=devicePixelRatio;Rt!=i&&(Rt=i,wc&&ff(J0,wc,uf),wc=matchMedia(`(min-resolution: ${Rt-.001}dppx) and (max-resolution: ${Rt+.001}dppx)`),Pr(J0,wc,uf),co.dispatchEvent(new CustomEvent(Cc)))}function ui(i,e){if(e!=null){let t=i.classList;!t.contains(e)&&t.add(e)}}function df(i,e){let t=i.classList;t.contains(e)&&t.remove(e)}function Yt(i,e,t){i.style[e]=t+"px"}function Ui(i,e,t,n){let s=hf.createElement(i);return e!=null&&ui(s,e),t?.insertBefore(s,n),s}function wi(i,e){return Ui("div",i,e)}var Q0=new WeakMap;function ss(i,e,t,n,s){let r="translate("+e+"px,"+t+"px)",o=Q0.get(i);r!=o&&(i.style.transform=r,Q0.set(i,r),e<0||t<0||e>n||t>s?ui(i,Rr):df(i,Rr))}var e_=new WeakMap;function t_(i,e,t){let n=e+t,s=e_.get(i);n!=s&&(e_.set(i,n),i.style.background=e,i.style.borderColor=t)}var n_=new WeakMap;function i_(i,e,t,n){let s=e+""+t,r=n_.get(i);s!=r&&(n_.set(i,s),i.style.height=t+"px",i.style.width=e+"px",i.style.marginLeft=n?-e/2+"px":0,i.style.marginTop=n?-t/2+"px":0)}var Sf={passive:!0},LM={...Sf,capture:!0};function Pr(i,e,t,n){e.addEventListener(i,t,n?LM:Sf)}function ff(i,e,t,n){e.removeEventListener(i,t,Sf)}mo&&uf();function Fi(i,e,t,n){let s;t=t||0,n=n||e.length-1;let r=n<=2147483647;for(;n-t>1;)s=r?t+n>>1:di((t+n)/2),e[s]<i?t=s:n=s;return i-e[t]<=e[n]-i?t:n}function I_(i){return(t,n,s)=>{let r=-1,o=-1;for(let a=n;a<=s;a++)if(i(t[a])){r=a;break}for(let a=s;a>=n;a--)if(i(t[a])){o=a;break}return[r,o]}}var L_=i=>i!=null,D_=i=>i!=null&&i>0,Ic=I_(L_),DM=I_(D_);function NM(i,e,t,n=0,s=!1){let r=s?DM:Ic,o=s?D_:L_;[e,t]=r(i,e,t);let a=i[e],l=i[e];if(e>-1)if(n==1)a=i[e],l=i[t];else if(n==-1)a=i[t],l=i[e];else for(let c=e;c<=t;c++){let h=i[c];o(h)&&(h<a?a=h:h>l&&(l=h))}return[a??Vt,l??-Vt]}function Lc(i,e,t,n){let s=o_(i),r=o_(e);i==e&&(s==-1?(i*=t,e/=t):(i/=t,e*=t));let o=t==10?Ss:N_,a=s==1?di:Ei,l=r==1?Ei:di,c=a(o(Sn(i))),h=l(o(Sn(e))),u=ho(t,c),d=ho(t,h);return t==10&&(c<0&&(u=Gt(u,-c)),h<0&&(d=Gt(d,-h))),n||t==2?(i=u*s,e=d*r):(i=k_(i,u),e=Dc(e,d)),[i,e]}function Mf(i,e,t,n){let s=Lc(i,e,t,n);return i==0&&(s[0]=0),e==0&&(s[1]=0),s}var wf=.1,s_={mode:3,pad:wf},Na={pad:0,soft:null,mode:0},OM={min:Na,max:Na};function Rc(i,e,t,n){return Nc(t)?r_(i,e,t):(Na.pad=t,Na.soft=n?0:null,Na.mode=n?3:0,r_(i,e,OM))}function At(i,e){return i??e}function UM(i,e,t){for(e=At(e,0),t=At(t,i.length-1);e<=t;){if(i[e]!=null)return!0;e++}return!1}function r_(i,e,t){let n=t.min,s=t.max,r=At(n.pad,0),o=At(s.pad,0),a=At(n.hard,-Vt),l=At(s.hard,Vt),c=At(n.soft,Vt),h=At(s.soft,-Vt),u=At(n.mode,0),d=At(s.mode,0),f=e-i,p=Ss(f),_=Yn(Sn(i),Sn(e)),m=Ss(_),g=Sn(m-p);(f<1e-24||g>10)&&(f=0,(i==0||e==0)&&(f=1e-24,u==2&&c!=Vt&&(r=0),d==2&&h!=-Vt&&(o=0)));let x=f||_||1e3,C=Ss(x),b=ho(10,di(C)),A=x*(f==0?i==0?.1:1:r),S=Gt(k_(i-A,b/10),24),y=i>=c&&(u==1||u==3&&S<=c||u==2&&S>=c)?c:Vt,M=Yn(a,S<y&&i>=y?y:ki(y,S)),U=x*(f==0?e==0?.1:1:o),N=Gt(Dc(e+U,b/10),24),L=e<=h&&(d==1||d==3&&N>=h||d==2&&N<=h)?h:-Vt,V=ki(l,N>L&&e<=L?L:Yn(L,N));return M==V&&M==0&&(V=100),[M,V]}var FM=new Intl.NumberFormat(mo?IM.language:"en-US"),Ef=i=>FM.format(i),fi=Math,Ac=fi.PI,Sn=fi.abs,di=fi.floor,bn=fi.round,Ei=fi.ceil,ki=fi.min,Yn=fi.max,ho=fi.pow,o_=fi.sign,Ss=fi.log10,N_=fi.log2,kM=(i,e=1)=>fi.sinh(i)*e,of=(i,e=1)=>fi.asinh(i/e),Vt=1/0;function a_(i){return(Ss((i^i>>31)-(i>>31))|0)+1}function pf(i,e,t){return ki(Yn(i,e),t)}function O_(i){return typeof i=="function"}function bt(i){return O_(i)?i:()=>i}var BM=()=>{},U_=i=>i,F_=(i,e)=>e,zM=i=>null,l_=i=>!0,c_=(i,e)=>i==e,VM=/\.\d*?(?=9{6,}|0{6,})/gm,Ir=i=>{if(z_(i)||Ks.has(i))return i;let e=`${i}`,t=e.match(VM);if(t==null)return i;let n=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${Ir(s)}e${r}`}return Gt(i,n)};function Ar(i,e){return Ir(Gt(Ir(i/e))*e)}function Dc(i,e){return Ir(Ei(Ir(i/e))*e)}function k_(i,e){return Ir(di(Ir(i/e))*e)}function Gt(i,e=0){if(z_(i))return i;let t=10**e,n=i*t*(1+Number.EPSILON);return bn(n)/t}var Ks=new Map;function B_(i){return((""+i).split(".")[1]||"").length}function Ua(i,e,t,n){let s=[],r=n.map(B_);for(let o=e;o<t;o++){let a=Sn(o),l=Gt(ho(i,o),a);for(let c=0;c<n.length;c++){let h=i==10?+`${n[c]}e${o}`:n[c]*l,u=(o>=0?0:a)+(o>=r[c]?0:r[c]),d=i==10?h:Gt(h,u);s.push(d),Ks.set(d,u)}}return s}var Oa={},Tf=[],uo=[null,null],Zs=Array.isArray,z_=Number.isInteger,GM=i=>i===void 0;function h_(i){return typeof i=="string"}function Nc(i){let e=!1;if(i!=null){let t=i.constructor;e=t==null||t==Object}return e}function HM(i){return i!=null&&typeof i=="object"}var WM=Object.getPrototypeOf(Uint8Array),V_="__proto__";function fo(i,e=Nc){let t;if(Zs(i)){let n=i.find(s=>s!=null);if(Zs(n)||e(n)){t=Array(i.length);for(let s=0;s<i.length;s++)t[s]=fo(i[s],e)}else t=i.slice()}else if(i instanceof WM)t=i.slice();else if(e(i)){t={};for(let n in i)n!=V_&&(t[n]=fo(i[n],e))}else t=i;return t}function gn(i){let e=arguments;for(let t=1;t<e.length;t++){let n=e[t];for(let s in n)s!=V_&&(Nc(i[s])?gn(i[s],fo(n[s])):i[s]=fo(n[s]))}return i}var $M=0,qM=1,XM=2;function YM(i,e,t){for(let n=0,s,r=-1;n<e.length;n++){let o=e[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<t&&i[s]==null;)i[r=s++]=null}}}function jM(i,e){if(JM(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return QM(o[0])||(o=KM(o)),o}let t=new Set;for(let o=0;o<i.length;o++){let l=i[o][0],c=l.length;for(let h=0;h<c;h++)t.add(l[h])}let n=[Array.from(t).sort((o,a)=>o-a)],s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],l=a[0];for(let c=1;c<a.length;c++){let h=a[c],u=Array(s).fill(void 0),d=e?e[o][c]:qM,f=[];for(let p=0;p<h.length;p++){let _=h[p],m=r.get(l[p]);_===null?d!=$M&&(u[m]=_,d==XM&&f.push(m)):u[m]=_}YM(u,f,s),n.push(u)}}return n}var ZM=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function KM(i){let e=i[0],t=e.length,n=Array(t);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<i.length;r++){let o=i[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[n[l]];s.push(a)}return s}function JM(i){let e=i[0][0],t=e.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function QM(i,e=100){let t=i.length;if(t<=1)return!0;let n=0,s=t-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=Yn(1,di((s-n+1)/e));for(let o=i[n],a=n+r;a<=s;a+=r){let l=i[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var G_=["January","February","March","April","May","June","July","August","September","October","November","December"],H_=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function W_(i){return i.slice(0,3)}var ew=H_.map(W_),tw=G_.map(W_),nw={MMMM:G_,MMM:tw,WWWW:H_,WWW:ew};function Pa(i){return(i<10?"0":"")+i}function iw(i){return(i<10?"00":i<100?"0":"")+i}var sw={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,e)=>e.MMMM[i.getMonth()],MMM:(i,e)=>e.MMM[i.getMonth()],MM:i=>Pa(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>Pa(i.getDate()),D:i=>i.getDate(),WWWW:(i,e)=>e.WWWW[i.getDay()],WWW:(i,e)=>e.WWW[i.getDay()],HH:i=>Pa(i.getHours()),H:i=>i.getHours(),h:i=>{let e=i.getHours();return e==0?12:e>12?e-12:e},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>Pa(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>Pa(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>iw(i.getMilliseconds())};function Af(i,e){e=e||nw;let t=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)t.push(s[0][0]=="{"?sw[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var rw=new Intl.DateTimeFormat().resolvedOptions().timeZone;function ow(i,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+i+i.getTimezoneOffset()*6e4):e==rw?t=i:(t=new Date(i.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(i.getMilliseconds())),t}var $_=i=>i%1==0,Pc=[1,2,2.5,5],aw=Ua(10,-32,0,Pc),q_=Ua(10,0,32,Pc),lw=q_.filter($_),Cr=aw.concat(q_),Cf=`
`,X_="{YYYY}",u_=Cf+X_,Y_="{M}/{D}",Da=Cf+Y_,Ec=Da+"/{YY}",j_="{aa}",cw="{h}:{mm}",lo=cw+j_,d_=Cf+lo,f_=":{ss}",Lt=null;function Z_(i){let e=i*1e3,t=e*60,n=t*60,s=n*24,r=s*30,o=s*365,l=(i==1?Ua(10,0,3,Pc).filter($_):Ua(10,-3,0,Pc)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,X_,Lt,Lt,Lt,Lt,Lt,Lt,1],[s*28,"{MMM}",u_,Lt,Lt,Lt,Lt,Lt,1],[s,Y_,u_,Lt,Lt,Lt,Lt,Lt,1],[n,"{h}"+j_,Ec,Lt,Da,Lt,Lt,Lt,1],[t,lo,Ec,Lt,Da,Lt,Lt,Lt,1],[e,f_,Ec+" "+lo,Lt,Da+" "+lo,Lt,d_,Lt,1],[i,f_+".{fff}",Ec+" "+lo,Lt,Da+" "+lo,Lt,d_,Lt,1]];function h(u){return(d,f,p,_,m,g)=>{let x=[],C=m>=o,b=m>=r&&m<o,A=u(p),S=Gt(A*i,3),y=af(A.getFullYear(),C?0:A.getMonth(),b||C?1:A.getDate()),M=Gt(y*i,3);if(b||C){let U=b?m/r:0,N=C?m/o:0,L=S==M?S:Gt(af(y.getFullYear()+N,y.getMonth()+U,1)*i,3),V=new Date(bn(L/i)),W=V.getFullYear(),O=V.getMonth();for(let G=0;L<=_;G++){let j=af(W+N*G,O+U*G,1),z=j-u(Gt(j*i,3));L=Gt((+j+z)*i,3),L<=_&&x.push(L)}}else{let U=m>=s?s:m,N=di(p)-di(S),L=M+N+Dc(S-M,U);x.push(L);let V=u(L),W=V.getHours()+V.getMinutes()/t+V.getSeconds()/n,O=m/n,G=d.axes[f]._space,j=g/G;for(;L=Gt(L+m,i==1?0:3),!(L>_);)if(O>1){let z=di(Gt(W+O,6))%24,J=u(L).getHours()-z;J>1&&(J=-1),L-=J*n,W=(W+O)%24;let ie=x[x.length-1];Gt((L-ie)/m,3)*j>=.7&&x.push(L)}else x.push(L)}return x}}return[l,c,h]}var[hw,uw,dw]=Z_(1),[fw,pw,mw]=Z_(.001);Ua(2,-53,53,[1]);function p_(i,e){return i.map(t=>t.map((n,s)=>s==0||s==8||n==null?n:e(s==1||t[8]==0?n:t[1]+n)))}function m_(i,e){return(t,n,s,r,o)=>{let a=e.find(p=>o>=p[0])||e[e.length-1],l,c,h,u,d,f;return n.map(p=>{let _=i(p),m=_.getFullYear(),g=_.getMonth(),x=_.getDate(),C=_.getHours(),b=_.getMinutes(),A=_.getSeconds(),S=m!=l&&a[2]||g!=c&&a[3]||x!=h&&a[4]||C!=u&&a[5]||b!=d&&a[6]||A!=f&&a[7]||a[1];return l=m,c=g,h=x,u=C,d=b,f=A,S(_)})}}function gw(i,e){let t=Af(e);return(n,s,r,o,a)=>s.map(l=>t(i(l)))}function af(i,e,t){return new Date(i,e,t)}function g_(i,e){return e(i)}var _w="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function __(i,e){return(t,n,s,r)=>r==null?bf:e(i(n))}function yw(i,e){let t=i.series[e];return t.width?t.stroke(i,e):t.points.width?t.points.stroke(i,e):null}function xw(i,e){return i.series[e].fill(i,e)}var vw={show:!0,live:!0,isolate:!1,mount:BM,markers:{show:!0,width:2,stroke:yw,fill:xw,dash:"solid"},idx:null,idxs:null,values:[]};function bw(i,e){let t=i.cursor.points,n=wi(),s=t.size(i,e);Yt(n,Ia,s),Yt(n,La,s);let r=s/-2;Yt(n,"marginLeft",r),Yt(n,"marginTop",r);let o=t.width(i,e,s);return o&&Yt(n,"borderWidth",o),n}function Sw(i,e){let t=i.series[e].points;return t._fill||t._stroke}function Mw(i,e){let t=i.series[e].points;return t._stroke||t._fill}function ww(i,e){return i.series[e].points.size}var lf=[0,0];function Ew(i,e,t){return lf[0]=e,lf[1]=t,lf}function Tc(i,e,t,n=!0){return s=>{s.button==0&&(!n||s.target==e)&&t(s)}}function cf(i,e,t,n=!0){return s=>{(!n||s.target==e)&&t(s)}}var Tw={show:!0,x:!0,y:!0,lock:!1,move:Ew,points:{one:!1,show:bw,size:ww,width:0,stroke:Mw,fill:Sw},bind:{mousedown:Tc,mouseup:Tc,click:Tc,dblclick:Tc,mousemove:cf,mouseleave:cf,mouseenter:cf},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,e,t,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},K_={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Rf=gn({},K_,{filter:F_}),J_=gn({},Rf,{size:10}),Q_=gn({},K_,{show:!1}),Pf='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',ey="bold "+Pf,ty=1.5,y_={show:!0,scale:"x",stroke:vf,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:ey,side:2,grid:Rf,ticks:J_,border:Q_,font:Pf,lineGap:ty,rotate:0},Aw="Value",Cw="Time",x_={show:!0,scale:"x",auto:!1,sorted:1,min:Vt,max:-Vt,idxs:[]};function Rw(i,e,t,n,s){return e.map(r=>r==null?"":Ef(r))}function Pw(i,e,t,n,s,r,o){let a=[],l=Ks.get(s)||0;t=o?t:Gt(Dc(t,s),l);for(let c=t;c<=n;c=Gt(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function mf(i,e,t,n,s,r,o){let a=[],l=i.scales[i.axes[e].scale].log,c=l==10?Ss:N_,h=di(c(t));s=ho(l,h),l==10&&(s=Cr[Fi(s,Cr)]);let u=t,d=s*l;l==10&&(d=Cr[Fi(d,Cr)]);do a.push(u),u=u+s,l==10&&!Ks.has(u)&&(u=Gt(u,Ks.get(s))),u>=d&&(s=u,d=s*l,l==10&&(d=Cr[Fi(d,Cr)]));while(u<=n);return a}function Iw(i,e,t,n,s,r,o){let l=i.scales[i.axes[e].scale].asinh,c=n>l?mf(i,e,Yn(l,t),n,s):[l],h=n>=0&&t<=0?[0]:[];return(t<-l?mf(i,e,Yn(l,-n),-t,s):[l]).reverse().map(d=>-d).concat(h,c)}var ny=/./,Lw=/[12357]/,Dw=/[125]/,v_=/1/,gf=(i,e,t,n)=>i.map((s,r)=>e==4&&s==0||r%n==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function Nw(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=i.scales[o],l=i.valToPos,c=r._space,h=l(10,o),u=l(9,o)-h>=c?ny:l(7,o)-h>=c?Lw:l(5,o)-h>=c?Dw:v_;if(u==v_){let d=Sn(l(1,o)-h);if(d<c)return gf(e.slice().reverse(),a.distr,u,Ei(c/d)).reverse()}return gf(e,a.distr,u,1)}function Ow(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=r._space,l=i.valToPos,c=Sn(l(1,o)-l(2,o));return c<a?gf(e.slice().reverse(),3,ny,Ei(a/c)).reverse():e}function Uw(i,e,t,n){return n==null?bf:e==null?"":Ef(e)}var b_={show:!0,scale:"y",stroke:vf,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:ey,side:3,grid:Rf,ticks:J_,border:Q_,font:Pf,lineGap:ty,rotate:0};function Fw(i,e){let t=3+(i||1)*2;return Gt(t*e,3)}function kw(i,e){let{scale:t,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],t,!0),o=i.valToPos(s[n[1]],t,!0),a=Sn(o-r),l=i.series[e],c=a/(l.points.space*Rt);return n[1]-n[0]<=c}var S_={scale:null,auto:!0,sorted:0,min:Vt,max:-Vt},iy=(i,e,t,n,s)=>s,M_={show:!0,auto:!0,sorted:0,gaps:iy,alpha:1,facets:[gn({},S_,{scale:"x"}),gn({},S_,{scale:"y"})]},w_={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:iy,alpha:1,points:{show:kw,filter:null},values:null,min:Vt,max:-Vt,idxs:[],path:null,clip:null};function Bw(i,e,t,n,s){return t/10}var sy={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},zw=gn({},sy,{time:!1,ori:1}),E_={};function ry(i,e){let t=E_[i];return t||(t={key:i,plots:[],sub(n){t.plots.push(n)},unsub(n){t.plots=t.plots.filter(s=>s!=n)},pub(n,s,r,o,a,l,c){for(let h=0;h<t.plots.length;h++)t.plots[h]!=s&&t.plots[h].pub(n,s,r,o,a,l,c)}},i!=null&&(E_[i]=t)),t}var po=1,_f=2;function Lr(i,e,t){let n=i.mode,s=i.series[e],r=n==2?i._data[e]:i._data,o=i.scales,a=i.bbox,l=r[0],c=n==2?r[1]:r[e],h=n==2?o[s.facets[0].scale]:o[i.series[0].scale],u=n==2?o[s.facets[1].scale]:o[s.scale],d=a.left,f=a.top,p=a.width,_=a.height,m=i.valToPosH,g=i.valToPosV;return h.ori==0?t(s,l,c,h,u,m,g,d,f,p,_,Uc,go,kc,ay,cy):t(s,l,c,h,u,g,m,f,d,_,p,Fc,_o,Df,ly,hy)}function If(i,e){let t=0,n=0,s=At(i.bands,Tf);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?n|=1:n|=2)}return[t,n==1?-1:n==2?1:n==3?2:0]}function Vw(i,e,t,n,s){let r=i.mode,o=i.series[e],a=r==2?o.facets[1].scale:o.scale,l=i.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Ms(i,e,t,n,s,r){return Lr(i,e,(o,a,l,c,h,u,d,f,p,_,m)=>{let g=o.pxRound,x=c.dir*(c.ori==0?1:-1),C=c.ori==0?go:_o,b,A;x==1?(b=t,A=n):(b=n,A=t);let S=g(u(a[b],c,_,f)),y=g(d(l[b],h,m,p)),M=g(u(a[A],c,_,f)),U=g(d(r==1?h.max:h.min,h,m,p)),N=new Path2D(s);return C(N,M,U),C(N,S,U),C(N,S,y),N})}function Oc(i,e,t,n,s,r){let o=null;if(i.length>0){o=new Path2D;let a=e==0?kc:Df,l=t;for(let u=0;u<i.length;u++){let d=i[u];if(d[1]>d[0]){let f=d[0]-l;f>0&&a(o,l,n,f,n+r),l=d[1]}}let c=t+s-l,h=10;c>0&&a(o,l,n-h/2,c,n+r+h)}return o}function Gw(i,e,t){let n=i[i.length-1];n&&n[0]==e?n[1]=t:i.push([e,t])}function Lf(i,e,t,n,s,r,o){let a=[],l=i.length;for(let c=s==1?t:n;c>=t&&c<=n;c+=s)if(e[c]===null){let u=c,d=c;if(s==1)for(;++c<=n&&e[c]===null;)d=c;else for(;--c>=t&&e[c]===null;)d=c;let f=r(i[u]),p=d==u?f:r(i[d]),_=u-s;f=o<=0&&_>=0&&_<l?r(i[_]):f;let g=d+s;p=o>=0&&g>=0&&g<l?r(i[g]):p,p>=f&&a.push([f,p])}return a}function T_(i){return i==0?U_:i==1?bn:e=>Ar(e,i)}function oy(i){let e=i==0?Uc:Fc,t=i==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},n=i==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,h=0)=>{c==0&&h==0?n(s,r,o,a,l):(c=ki(c,a/2,l/2),h=ki(h,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,h),t(s,r,o+l,r,o,h),t(s,r,o,r+a,o,c),s.closePath())}}var Uc=(i,e,t)=>{i.moveTo(e,t)},Fc=(i,e,t)=>{i.moveTo(t,e)},go=(i,e,t)=>{i.lineTo(e,t)},_o=(i,e,t)=>{i.lineTo(t,e)},kc=oy(0),Df=oy(1),ay=(i,e,t,n,s,r)=>{i.arc(e,t,n,s,r)},ly=(i,e,t,n,s,r)=>{i.arc(t,e,n,s,r)},cy=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(e,t,n,s,r,o)},hy=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(t,e,s,n,o,r)};function uy(i){return(e,t,n,s,r)=>Lr(e,t,(o,a,l,c,h,u,d,f,p,_,m)=>{let{pxRound:g,points:x}=o,C,b;c.ori==0?(C=Uc,b=ay):(C=Fc,b=ly);let A=Gt(x.width*Rt,3),S=(x.size-x.width)/2*Rt,y=Gt(S*2,3),M=new Path2D,U=new Path2D,{left:N,top:L,width:V,height:W}=e.bbox;kc(U,N-y,L-y,V+y*2,W+y*2);let O=G=>{if(l[G]!=null){let j=g(u(a[G],c,_,f)),z=g(d(l[G],h,m,p));C(M,j+S,z),b(M,j,z,S,0,Ac*2)}};if(r)r.forEach(O);else for(let G=n;G<=s;G++)O(G);return{stroke:A>0?M:null,fill:M,clip:U,flags:po|_f}})}function dy(i){return(e,t,n,s,r,o)=>{n!=s&&(r!=n&&o!=n&&i(e,t,n),r!=s&&o!=s&&i(e,t,s),i(e,t,o))}}var Hw=dy(go),Ww=dy(_o);function fy(i){let e=At(i?.alignGaps,0);return(t,n,s,r)=>Lr(t,n,(o,a,l,c,h,u,d,f,p,_,m)=>{[s,r]=Ic(l,s,r);let g=o.pxRound,x=W=>g(u(W,c,_,f)),C=W=>g(d(W,h,m,p)),b,A;c.ori==0?(b=go,A=Hw):(b=_o,A=Ww);let S=c.dir*(c.ori==0?1:-1),y={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:po},M=y.stroke,U=!1;if(r-s>=_*4){let W=de=>t.posToVal(de,c.key,!0),O=null,G=null,j,z,ce,Z=x(a[S==1?s:r]),J=x(a[s]),ie=x(a[r]),fe=W(S==1?J+1:ie-1);for(let de=S==1?s:r;de>=s&&de<=r;de+=S){let Q=a[de],xe=(S==1?Q<fe:Q>fe)?Z:x(Q),Pe=l[de];xe==Z?Pe!=null?(z=Pe,O==null?(b(M,xe,C(z)),j=O=G=z):z<O?O=z:z>G&&(G=z)):Pe===null&&(U=!0):(O!=null&&A(M,Z,C(O),C(G),C(j),C(z)),Pe!=null?(z=Pe,b(M,xe,C(z)),O=G=j=z):(O=G=null,Pe===null&&(U=!0)),Z=xe,fe=W(Z+S))}O!=null&&O!=G&&ce!=Z&&A(M,Z,C(O),C(G),C(j),C(z))}else for(let W=S==1?s:r;W>=s&&W<=r;W+=S){let O=l[W];O===null?U=!0:O!=null&&b(M,x(a[W]),C(O))}let[L,V]=If(t,n);if(o.fill!=null||L!=0){let W=y.fill=new Path2D(M),O=o.fillTo(t,n,o.min,o.max,L),G=C(O),j=x(a[s]),z=x(a[r]);S==-1&&([z,j]=[j,z]),b(W,z,G),b(W,j,G)}if(!o.spanGaps){let W=[];U&&W.push(...Lf(a,l,s,r,S,x,e)),y.gaps=W=o.gaps(t,n,s,r,W),y.clip=Oc(W,c.ori,f,p,_,m)}return V!=0&&(y.band=V==2?[Ms(t,n,s,r,M,-1),Ms(t,n,s,r,M,1)]:Ms(t,n,s,r,M,V)),y})}function $w(i){let e=At(i.align,1),t=At(i.ascDesc,!1),n=At(i.alignGaps,0),s=At(i.extend,!1);return(r,o,a,l)=>Lr(r,o,(c,h,u,d,f,p,_,m,g,x,C)=>{[a,l]=Ic(u,a,l);let b=c.pxRound,{left:A,width:S}=r.bbox,y=J=>b(p(J,d,x,m)),M=J=>b(_(J,f,C,g)),U=d.ori==0?go:_o,N={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:po},L=N.stroke,V=d.dir*(d.ori==0?1:-1),W=M(u[V==1?a:l]),O=y(h[V==1?a:l]),G=O,j=O;s&&e==-1&&(j=A,U(L,j,W)),U(L,O,W);for(let J=V==1?a:l;J>=a&&J<=l;J+=V){let ie=u[J];if(ie==null)continue;let fe=y(h[J]),de=M(ie);e==1?U(L,fe,W):U(L,G,de),U(L,fe,de),W=de,G=fe}let z=G;s&&e==1&&(z=A+S,U(L,z,W));let[ce,Z]=If(r,o);if(c.fill!=null||ce!=0){let J=N.fill=new Path2D(L),ie=c.fillTo(r,o,c.min,c.max,ce),fe=M(ie);U(J,z,fe),U(J,j,fe)}if(!c.spanGaps){let J=[];J.push(...Lf(h,u,a,l,V,y,n));let ie=c.width*Rt/2,fe=t||e==1?ie:-ie,de=t||e==-1?-ie:ie;J.forEach(Q=>{Q[0]+=fe,Q[1]+=de}),N.gaps=J=c.gaps(r,o,a,l,J),N.clip=Oc(J,d.ori,m,g,x,C)}return Z!=0&&(N.band=Z==2?[Ms(r,o,a,l,L,-1),Ms(r,o,a,l,L,1)]:Ms(r,o,a,l,L,Z)),N})}function A_(i,e,t,n,s,r,o=Vt){if(i.length>1){let a=null;for(let l=0,c=1/0;l<i.length;l++)if(e[l]!==void 0){if(a!=null){let h=Sn(i[l]-i[a]);h<c&&(c=h,o=Sn(t(i[l],n,s,r)-t(i[a],n,s,r)))}a=l}}return o}function qw(i){i=i||Oa;let e=At(i.size,[.6,Vt,1]),t=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=bt(s),o=1-e[0],a=At(e[1],Vt),l=At(e[2],1),c=At(i.disp,Oa),h=At(i.each,f=>{}),{fill:u,stroke:d}=c;return(f,p,_,m)=>Lr(f,p,(g,x,C,b,A,S,y,M,U,N,L)=>{let V=g.pxRound,W=t,O=n*Rt,G=a*Rt,j=l*Rt,z,ce;b.ori==0?[z,ce]=r(f,p):[ce,z]=r(f,p);let Z=b.dir*(b.ori==0?1:-1),J=b.ori==0?kc:Df,ie=b.ori==0?h:(Le,Ke,lt,Ee,zt,We,je)=>{h(Le,Ke,lt,zt,Ee,je,We)},fe=At(f.bands,Tf).find(Le=>Le.series[0]==p),de=fe!=null?fe.dir:0,Q=g.fillTo(f,p,g.min,g.max,de),ge=V(y(Q,A,L,U)),xe,Pe,we,Xe=N,at=V(g.width*Rt),$e=!1,mt=null,dt=null,st=null,Zt=null;u!=null&&(at==0||d!=null)&&($e=!0,mt=u.values(f,p,_,m),dt=new Map,new Set(mt).forEach(Le=>{Le!=null&&dt.set(Le,new Path2D)}),at>0&&(st=d.values(f,p,_,m),Zt=new Map,new Set(st).forEach(Le=>{Le!=null&&Zt.set(Le,new Path2D)})));let{x0:Ht,size:hn}=c;if(Ht!=null&&hn!=null){W=1,x=Ht.values(f,p,_,m),Ht.unit==2&&(x=x.map(lt=>f.posToVal(M+lt*N,b.key,!0)));let Le=hn.values(f,p,_,m);hn.unit==2?Pe=Le[0]*N:Pe=S(Le[0],b,N,M)-S(0,b,N,M),Xe=A_(x,C,S,b,N,M,Xe),we=Xe-Pe+O}else Xe=A_(x,C,S,b,N,M,Xe),we=Xe*o+O,Pe=Xe-we;we<1&&(we=0),at>=Pe/2&&(at=0),we<5&&(V=U_);let kt=we>0,Cn=Xe-we-(kt?at:0);Pe=V(pf(Cn,j,G)),xe=(W==0?Pe/2:W==Z?0:Pe)-W*Z*((W==0?O/2:0)+(kt?at/2:0));let wt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},yn=$e?null:new Path2D,tn=null;if(fe!=null)tn=f.data[fe.series[1]];else{let{y0:Le,y1:Ke}=c;Le!=null&&Ke!=null&&(C=Ke.values(f,p,_,m),tn=Le.values(f,p,_,m))}let un=z*Pe,k=ce*Pe;for(let Le=Z==1?_:m;Le>=_&&Le<=m;Le+=Z){let Ke=C[Le];if(Ke==null)continue;if(tn!=null){let $=tn[Le]??0;if(Ke-$==0)continue;ge=y($,A,L,U)}let lt=b.distr!=2||c!=null?x[Le]:Le,Ee=S(lt,b,N,M),zt=y(At(Ke,Q),A,L,U),We=V(Ee-xe),je=V(Yn(zt,ge)),R=V(ki(zt,ge)),w=je-R;if(Ke!=null){let $=Ke<0?k:un,he=Ke<0?un:k;$e?(at>0&&st[Le]!=null&&J(Zt.get(st[Le]),We,R+di(at/2),Pe,Yn(0,w-at),$,he),mt[Le]!=null&&J(dt.get(mt[Le]),We,R+di(at/2),Pe,Yn(0,w-at),$,he)):J(yn,We,R+di(at/2),Pe,Yn(0,w-at),$,he),ie(f,p,Le,We-at/2,R,Pe+at,w)}}return at>0?wt.stroke=$e?Zt:yn:$e||(wt._fill=g.width==0?g._fill:g._stroke??g._fill,wt.width=0),wt.fill=$e?dt:yn,wt})}function Xw(i,e){let t=At(e?.alignGaps,0);return(n,s,r,o)=>Lr(n,s,(a,l,c,h,u,d,f,p,_,m,g)=>{[r,o]=Ic(c,r,o);let x=a.pxRound,C=z=>x(d(z,h,m,p)),b=z=>x(f(z,u,g,_)),A,S,y;h.ori==0?(A=Uc,y=go,S=cy):(A=Fc,y=_o,S=hy);let M=h.dir*(h.ori==0?1:-1),U=C(l[M==1?r:o]),N=U,L=[],V=[];for(let z=M==1?r:o;z>=r&&z<=o;z+=M)if(c[z]!=null){let Z=l[z],J=C(Z);L.push(N=J),V.push(b(c[z]))}let W={stroke:i(L,V,A,y,S,x),fill:null,clip:null,band:null,gaps:null,flags:po},O=W.stroke,[G,j]=If(n,s);if(a.fill!=null||G!=0){let z=W.fill=new Path2D(O),ce=a.fillTo(n,s,a.min,a.max,G),Z=b(ce);y(z,N,Z),y(z,U,Z)}if(!a.spanGaps){let z=[];z.push(...Lf(l,c,r,o,M,C,t)),W.gaps=z=a.gaps(n,s,r,o,z),W.clip=Oc(z,h.ori,p,_,m,g)}return j!=0&&(W.band=j==2?[Ms(n,s,r,o,O,-1),Ms(n,s,r,o,O,1)]:Ms(n,s,r,o,O,j)),W})}function Yw(i){return Xw(jw,i)}function jw(i,e,t,n,s,r){let o=i.length;if(o<2)return null;let a=new Path2D;if(t(a,i[0],e[0]),o==2)n(a,i[1],e[1]);else{let l=Array(o),c=Array(o-1),h=Array(o-1),u=Array(o-1);for(let d=0;d<o-1;d++)h[d]=e[d+1]-e[d],u[d]=i[d+1]-i[d],c[d]=h[d]/u[d];l[0]=c[0];for(let d=1;d<o-1;d++)c[d]===0||c[d-1]===0||c[d-1]>0!=c[d]>0?l[d]=0:(l[d]=3*(u[d-1]+u[d])/((2*u[d]+u[d-1])/c[d-1]+(u[d]+2*u[d-1])/c[d]),isFinite(l[d])||(l[d]=0));l[o-1]=c[o-2];for(let d=0;d<o-1;d++)s(a,i[d]+u[d]/3,e[d]+l[d]*u[d]/3,i[d+1]-u[d]/3,e[d+1]-l[d+1]*u[d]/3,i[d+1],e[d+1])}return a}var yf=new Set;function C_(){for(let i of yf)i.syncRect(!0)}mo&&(Pr(RM,co,C_),Pr(PM,co,C_,!0),Pr(Cc,co,()=>{Fn.pxRatio=Rt}));var Zw=fy(),Kw=uy();function R_(i,e,t,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>xf(r,o,e,t))}function Jw(i,e){return i.map((t,n)=>n==0?{}:gn({},e,t))}function xf(i,e,t,n){return gn({},e==0?t:n,i)}function py(i,e,t){return e==null?uo:[e,t]}var Qw=py;function eE(i,e,t){return e==null?uo:Rc(e,t,wf,!0)}function my(i,e,t,n){return e==null?uo:Lc(e,t,i.scales[n].log,!1)}var tE=my;function gy(i,e,t,n){return e==null?uo:Mf(e,t,i.scales[n].log,!1)}var nE=gy;function iE(i,e,t,n,s){let r=Yn(a_(i),a_(e)),o=e-i,a=Fi(s/n*o,t);do{let l=t[a],c=n*l/o;if(c>=s&&r+(l<5?Ks.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function P_(i){let e,t;return i=i.replace(/(\d+)px/,(n,s)=>(e=bn((t=+s)*Rt))+"px"),[i,e,t]}function sE(i){i.show&&[i.font,i.labelFont].forEach(e=>{let t=Gt(e[2]*Rt,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function Fn(i,e,t){let n={mode:At(i.mode,1)},s=n.mode;function r(v,E,P,D){let H=E.valToPct(v);return D+P*(E.dir==-1?1-H:H)}function o(v,E,P,D){let H=E.valToPct(v);return D+P*(E.dir==-1?H:1-H)}function a(v,E,P,D){return E.ori==0?r(v,E,P,D):o(v,E,P,D)}n.valToPosH=r,n.valToPosV=o;let l=!1;n.status=0;let c=n.root=wi(uM);if(i.id!=null&&(c.id=i.id),ui(c,i.class),i.title){let v=wi(pM,c);v.textContent=i.title}let h=Ui("canvas"),u=n.ctx=h.getContext("2d"),d=wi(mM,c);Pr("click",d,v=>{v.target===p&&($t!=Kr||Kt!=Jr)&&Un.click(n,v)},!0);let f=n.under=wi(gM,d);d.appendChild(h);let p=n.over=wi(_M,d);i=fo(i);let _=+At(i.pxAlign,1),m=T_(_);(i.plugins||[]).forEach(v=>{v.opts&&(i=v.opts(n,i)||i)});let g=i.ms||.001,x=n.series=s==1?R_(i.series||[],x_,w_,!1):Jw(i.series||[null],M_),C=n.axes=R_(i.axes||[],y_,b_,!0),b=n.scales={},A=n.bands=i.bands||[];A.forEach(v=>{v.fill=bt(v.fill||null),v.dir=At(v.dir,-1)});let S=s==2?x[1].facets[0].scale:x[0].scale,y={axes:gs,series:_t},M=(i.drawOrder||["axes","series"]).map(v=>y[v]);function U(v){let E=v.distr==3?P=>Ss(P>0?P:v.clamp(n,P,v.min,v.max,v.key)):v.distr==4?P=>of(P,v.asinh):v.distr==100?P=>v.fwd(P):P=>P;return P=>{let D=E(P),{_min:H,_max:Y}=v,ae=Y-H;return(D-H)/ae}}function N(v){let E=b[v];if(E==null){let P=(i.scales||Oa)[v]||Oa;if(P.from!=null){N(P.from);let D=gn({},b[P.from],P,{key:v});D.valToPct=U(D),b[v]=D}else{E=b[v]=gn({},v==S?sy:zw,P),E.key=v;let D=E.time,H=E.range,Y=Zs(H);if((v!=S||s==2&&!D)&&(Y&&(H[0]==null||H[1]==null)&&(H={min:H[0]==null?s_:{mode:1,hard:H[0],soft:H[0]},max:H[1]==null?s_:{mode:1,hard:H[1],soft:H[1]}},Y=!1),!Y&&Nc(H))){let ae=H;H=(pe,be,Ue)=>be==null?uo:Rc(be,Ue,ae)}E.range=bt(H||(D?Qw:v==S?E.distr==3?tE:E.distr==4?nE:py:E.distr==3?my:E.distr==4?gy:eE)),E.auto=bt(Y?!1:E.auto),E.clamp=bt(E.clamp||Bw),E._min=E._max=null,E.valToPct=U(E)}}}N("x"),N("y"),s==1&&x.forEach(v=>{N(v.scale)}),C.forEach(v=>{N(v.scale)});for(let v in i.scales)N(v);let L=b[S],V=L.distr,W,O;L.ori==0?(ui(c,dM),W=r,O=o):(ui(c,fM),W=o,O=r);let G={};for(let v in b){let E=b[v];(E.min!=null||E.max!=null)&&(G[v]={min:E.min,max:E.max},E.min=E.max=null)}let j=i.tzDate||(v=>new Date(bn(v/g))),z=i.fmtDate||Af,ce=g==1?dw(j):mw(j),Z=m_(j,p_(g==1?uw:pw,z)),J=__(j,g_(_w,z)),ie=[],fe=n.legend=gn({},vw,i.legend),de=n.cursor=gn({},Tw,{drag:{y:s==2}},i.cursor),Q=fe.show,ge=de.show,xe=fe.markers;fe.idxs=ie,xe.width=bt(xe.width),xe.dash=bt(xe.dash),xe.stroke=bt(xe.stroke),xe.fill=bt(xe.fill);let Pe,we,Xe,at=[],$e=[],mt,dt=!1,st={};if(fe.live){let v=x[1]?x[1].values:null;dt=v!=null,mt=dt?v(n,1,0):{_:0};for(let E in mt)st[E]=bf}if(Q)if(Pe=Ui("table",MM,c),Xe=Ui("tbody",null,Pe),fe.mount(n,Pe),dt){we=Ui("thead",null,Pe,Xe);let v=Ui("tr",null,we);Ui("th",null,v);for(var Zt in mt)Ui("th",$0,v).textContent=Zt}else ui(Pe,EM),fe.live&&ui(Pe,wM);let Ht={show:!0},hn={show:!1};function kt(v,E){if(E==0&&(dt||!fe.live||s==2))return uo;let P=[],D=Ui("tr",TM,Xe,Xe.childNodes[E]);ui(D,v.class),v.show||ui(D,Rr);let H=Ui("th",null,D);if(xe.show){let pe=wi(AM,H);if(E>0){let be=xe.width(n,E);be&&(pe.style.border=be+"px "+xe.dash(n,E)+" "+xe.stroke(n,E)),pe.style.background=xe.fill(n,E)}}let Y=wi($0,H);v.label instanceof HTMLElement?Y.appendChild(v.label):Y.textContent=v.label,E>0&&(xe.show||(Y.style.color=v.width>0?xe.stroke(n,E):xe.fill(n,E)),wt("click",H,pe=>{if(de._lock)return;et(pe);let be=x.indexOf(v);if((pe.ctrlKey||pe.metaKey)!=fe.isolate){let Ue=x.some((Fe,Be)=>Be>0&&Be!=be&&Fe.show);x.forEach((Fe,Be)=>{Be>0&&Ji(Be,Ue?Be==be?Ht:hn:Ht,!0,mn.setSeries)})}else Ji(be,{show:!v.show},!0,mn.setSeries)},!1),tt&&wt(j0,H,pe=>{de._lock||(et(pe),Ji(x.indexOf(v),eo,!0,mn.setSeries))},!1));for(var ae in mt){let pe=Ui("td",CM,D);pe.textContent="--",P.push(pe)}return[D,P]}let Cn=new Map;function wt(v,E,P,D=!0){let H=Cn.get(E)||{},Y=de.bind[v](n,E,P,D);Y&&(Pr(v,E,H[v]=Y),Cn.set(E,H))}function yn(v,E,P){let D=Cn.get(E)||{};for(let H in D)(v==null||H==v)&&(ff(H,E,D[H]),delete D[H]);v==null&&Cn.delete(E)}let tn=0,un=0,k=0,Le=0,Ke=0,lt=0,Ee=Ke,zt=lt,We=k,je=Le,R=0,w=0,$=0,he=0;n.bbox={};let oe=!1,ye=!1,ve=!1,ee=!1,ne=!1,me=!1;function F(v,E,P){(P||v!=n.width||E!=n.height)&&se(v,E),ft(!1),ve=!0,ye=!0,kn()}function se(v,E){n.width=tn=k=v,n.height=un=Le=E,Ke=lt=0,Me(),qe();let P=n.bbox;R=P.left=Ar(Ke*Rt,.5),w=P.top=Ar(lt*Rt,.5),$=P.width=Ar(k*Rt,.5),he=P.height=Ar(Le*Rt,.5)}let te=3;function Te(){let v=!1,E=0;for(;!v;){E++;let P=Yr(E),D=Ki(E);v=E==te||P&&D,v||(se(n.width,n.height),ye=!0)}}function _e({width:v,height:E}){F(v,E)}n.setSize=_e;function Me(){let v=!1,E=!1,P=!1,D=!1;C.forEach((H,Y)=>{if(H.show&&H._show){let{side:ae,_size:pe}=H,be=ae%2,Ue=H.label!=null?H.labelSize:0,Fe=pe+Ue;Fe>0&&(be?(k-=Fe,ae==3?(Ke+=Fe,D=!0):P=!0):(Le-=Fe,ae==0?(lt+=Fe,v=!0):E=!0))}}),ji[0]=v,ji[1]=P,ji[2]=E,ji[3]=D,k-=Li[1]+Li[3],Ke+=Li[3],Le-=Li[2]+Li[0],lt+=Li[0]}function qe(){let v=Ke+k,E=lt+Le,P=Ke,D=lt;function H(Y,ae){switch(Y){case 1:return v+=ae,v-ae;case 2:return E+=ae,E-ae;case 3:return P-=ae,P+ae;case 0:return D-=ae,D+ae}}C.forEach((Y,ae)=>{if(Y.show&&Y._show){let pe=Y.side;Y._pos=H(pe,Y._size),Y.label!=null&&(Y._lpos=H(pe,Y.labelSize))}})}if(de.dataIdx==null){let v=de.hover,E=v.skip=new Set(v.skip??[]);E.add(void 0);let P=v.prox=bt(v.prox),D=v.bias??=0;de.dataIdx=(H,Y,ae,pe)=>{if(Y==0)return ae;let be=ae,Ue=P(H,Y,ae,pe)??Vt,Fe=Ue>=0&&Ue<Vt,Be=L.ori==0?k:Le,rt=de.left,Ct=e[0],Tt=e[Y];if(E.has(Tt[ae])){be=null;let xt=null,Je=null,Ye;if(D==0||D==-1)for(Ye=ae;xt==null&&Ye-- >0;)E.has(Tt[Ye])||(xt=Ye);if(D==0||D==1)for(Ye=ae;Je==null&&Ye++<Tt.length;)E.has(Tt[Ye])||(Je=Ye);if(xt!=null||Je!=null)if(Fe){let Xt=xt==null?-1/0:W(Ct[xt],L,Be,0),rn=Je==null?1/0:W(Ct[Je],L,Be,0),Ln=rt-Xt,Bt=rn-rt;Ln<=Bt?Ln<=Ue&&(be=xt):Bt<=Ue&&(be=Je)}else be=Je==null?xt:xt==null?Je:ae-xt<=Je-ae?xt:Je}else Fe&&Sn(rt-W(Ct[ae],L,Be,0))>Ue&&(be=null);return be}}let et=v=>{de.event=v};de.idxs=ie,de._lock=!1;let le=de.points;le.show=bt(le.show),le.size=bt(le.size),le.stroke=bt(le.stroke),le.width=bt(le.width),le.fill=bt(le.fill);let ze=n.focus=gn({},i.focus||{alpha:.3},de.focus),tt=ze.prox>=0,Ie=tt&&le.one,ct=[],Wt=[],Gn=[];function ra(v,E){let P=le.show(n,E);if(P instanceof HTMLElement)return ui(P,SM),ui(P,v.class),ss(P,-10,-10,k,Le),p.insertBefore(P,ct[E]),P}function $r(v,E){if(s==1||E>0){let P=s==1&&b[v.scale].time,D=v.value;v.value=P?h_(D)?__(j,g_(D,z)):D||J:D||Uw,v.label=v.label||(P?Cw:Aw)}if(Ie||E>0){v.width=v.width==null?1:v.width,v.paths=v.paths||Zw||zM,v.fillTo=bt(v.fillTo||Vw),v.pxAlign=+At(v.pxAlign,_),v.pxRound=T_(v.pxAlign),v.stroke=bt(v.stroke||null),v.fill=bt(v.fill||null),v._stroke=v._fill=v._paths=v._focus=null;let P=Fw(Yn(1,v.width),1),D=v.points=gn({},{size:P,width:Yn(1,P*.2),stroke:v.stroke,space:P*2,paths:Kw,_stroke:null,_fill:null},v.points);D.show=bt(D.show),D.filter=bt(D.filter),D.fill=bt(D.fill),D.stroke=bt(D.stroke),D.paths=bt(D.paths),D.pxAlign=v.pxAlign}if(Q){let P=kt(v,E);at.splice(E,0,P[0]),$e.splice(E,0,P[1]),fe.values.push(null)}if(ge){ie.splice(E,0,null);let P=null;Ie?E==0&&(P=ra(v,E)):E>0&&(P=ra(v,E)),ct.splice(E,0,P),Wt.splice(E,0,0),Gn.splice(E,0,0)}In("addSeries",E)}function gd(v,E){E=E??x.length,v=s==1?xf(v,E,x_,w_):xf(v,E,{},M_),x.splice(E,0,v),$r(x[E],E)}n.addSeries=gd;function Bl(v){if(x.splice(v,1),Q){fe.values.splice(v,1),$e.splice(v,1);let E=at.splice(v,1)[0];yn(null,E.firstChild),E.remove()}ge&&(ie.splice(v,1),ct.splice(v,1)[0].remove(),Wt.splice(v,1),Gn.splice(v,1)),In("delSeries",v)}n.delSeries=Bl;let ji=[!1,!1,!1,!1];function fs(v,E){if(v._show=v.show,v.show){let P=v.side%2,D=b[v.scale];D==null&&(v.scale=P?x[1].scale:S,D=b[v.scale]);let H=D.time;v.size=bt(v.size),v.space=bt(v.space),v.rotate=bt(v.rotate),Zs(v.incrs)&&v.incrs.forEach(ae=>{!Ks.has(ae)&&Ks.set(ae,B_(ae))}),v.incrs=bt(v.incrs||(D.distr==2?lw:H?g==1?hw:fw:Cr)),v.splits=bt(v.splits||(H&&D.distr==1?ce:D.distr==3?mf:D.distr==4?Iw:Pw)),v.stroke=bt(v.stroke),v.grid.stroke=bt(v.grid.stroke),v.ticks.stroke=bt(v.ticks.stroke),v.border.stroke=bt(v.border.stroke);let Y=v.values;v.values=Zs(Y)&&!Zs(Y[0])?bt(Y):H?Zs(Y)?m_(j,p_(Y,z)):h_(Y)?gw(j,Y):Y||Z:Y||Rw,v.filter=bt(v.filter||(D.distr>=3&&D.log==10?Nw:D.distr==3&&D.log==2?Ow:F_)),v.font=P_(v.font),v.labelFont=P_(v.labelFont),v._size=v.size(n,null,E,0),v._space=v._rotate=v._incrs=v._found=v._splits=v._values=null,v._size>0&&(ji[E]=!0,v._el=wi(yM,d))}}function ps(v,E,P,D){let[H,Y,ae,pe]=P,be=E%2,Ue=0;return be==0&&(pe||Y)&&(Ue=E==0&&!H||E==2&&!ae?bn(y_.size/3):0),be==1&&(H||ae)&&(Ue=E==1&&!Y||E==3&&!pe?bn(b_.size/2):0),Ue}let oa=n.padding=(i.padding||[ps,ps,ps,ps]).map(v=>bt(At(v,ps))),Li=n._padding=oa.map((v,E)=>v(n,E,ji,0)),nn,an=null,ln=null,Zi=s==1?x[0].idxs:null,ri=null,Vs=!1;function aa(v,E){if(e=v??[],n.data=n._data=e,s==2){nn=0;for(let P=1;P<x.length;P++)nn+=e[P][0].length}else{e.length==0&&(n.data=n._data=e=[[]]),ri=e[0],nn=ri.length;let P=e;if(V==2){P=e.slice();let D=P[0]=Array(nn);for(let H=0;H<nn;H++)D[H]=H}n._data=e=P}if(ft(!0),In("setData"),V==2&&(ve=!0),E!==!1){let P=L;P.auto(n,Vs)?la():Ws(S,P.min,P.max),ee=ee||de.left>=0,me=!0,kn()}}n.setData=aa;function la(){Vs=!0;let v,E;s==1&&(nn>0?(an=Zi[0]=0,ln=Zi[1]=nn-1,v=e[0][an],E=e[0][ln],V==2?(v=an,E=ln):v==E&&(V==3?[v,E]=Lc(v,v,L.log,!1):V==4?[v,E]=Mf(v,v,L.log,!1):L.time?E=v+bn(86400/g):[v,E]=Rc(v,E,wf,!0))):(an=Zi[0]=v=null,ln=Zi[1]=E=null)),Ws(S,v,E)}let qr,Gs,Xr,T,B,K,q,X,Ae,De;function Ce(v,E,P,D,H,Y){v??=X0,P??=Tf,D??="butt",H??=X0,Y??="round",v!=qr&&(u.strokeStyle=qr=v),H!=Gs&&(u.fillStyle=Gs=H),E!=Xr&&(u.lineWidth=Xr=E),Y!=B&&(u.lineJoin=B=Y),D!=K&&(u.lineCap=K=D),P!=T&&u.setLineDash(T=P)}function Ne(v,E,P,D){E!=Gs&&(u.fillStyle=Gs=E),v!=q&&(u.font=q=v),P!=X&&(u.textAlign=X=P),D!=Ae&&(u.textBaseline=Ae=D)}function Ge(v,E,P,D,H=0){if(D.length>0&&v.auto(n,Vs)&&(E==null||E.min==null)){let Y=At(an,0),ae=At(ln,D.length-1),pe=P.min==null?NM(D,Y,ae,H,v.distr==3):[P.min,P.max];v.min=ki(v.min,P.min=pe[0]),v.max=Yn(v.max,P.max=pe[1])}}let nt={min:null,max:null};function gt(){for(let D in b){let H=b[D];G[D]==null&&(H.min==null||G[S]!=null&&H.auto(n,Vs))&&(G[D]=nt)}for(let D in b){let H=b[D];G[D]==null&&H.from!=null&&G[H.from]!=null&&(G[D]=nt)}G[S]!=null&&ft(!0);let v={};for(let D in G){let H=G[D];if(H!=null){let Y=v[D]=fo(b[D],HM);if(H.min!=null)gn(Y,H);else if(D!=S||s==2)if(nn==0&&Y.from==null){let ae=Y.range(n,null,null,D);Y.min=ae[0],Y.max=ae[1]}else Y.min=Vt,Y.max=-Vt}}if(nn>0){x.forEach((D,H)=>{if(s==1){let Y=D.scale,ae=G[Y];if(ae==null)return;let pe=v[Y];if(H==0){let be=pe.range(n,pe.min,pe.max,Y);pe.min=be[0],pe.max=be[1],an=Fi(pe.min,e[0]),ln=Fi(pe.max,e[0]),ln-an>1&&(e[0][an]<pe.min&&an++,e[0][ln]>pe.max&&ln--),D.min=ri[an],D.max=ri[ln]}else D.show&&D.auto&&Ge(pe,ae,D,e[H],D.sorted);D.idxs[0]=an,D.idxs[1]=ln}else if(H>0&&D.show&&D.auto){let[Y,ae]=D.facets,pe=Y.scale,be=ae.scale,[Ue,Fe]=e[H],Be=v[pe],rt=v[be];Be!=null&&Ge(Be,G[pe],Y,Ue,Y.sorted),rt!=null&&Ge(rt,G[be],ae,Fe,ae.sorted),D.min=ae.min,D.max=ae.max}});for(let D in v){let H=v[D],Y=G[D];if(H.from==null&&(Y==null||Y.min==null)){let ae=H.range(n,H.min==Vt?null:H.min,H.max==-Vt?null:H.max,D);H.min=ae[0],H.max=ae[1]}}}for(let D in v){let H=v[D];if(H.from!=null){let Y=v[H.from];if(Y.min==null)H.min=H.max=null;else{let ae=H.range(n,Y.min,Y.max,D);H.min=ae[0],H.max=ae[1]}}}let E={},P=!1;for(let D in v){let H=v[D],Y=b[D];if(Y.min!=H.min||Y.max!=H.max){Y.min=H.min,Y.max=H.max;let ae=Y.distr;Y._min=ae==3?Ss(Y.min):ae==4?of(Y.min,Y.asinh):ae==100?Y.fwd(Y.min):Y.min,Y._max=ae==3?Ss(Y.max):ae==4?of(Y.max,Y.asinh):ae==100?Y.fwd(Y.max):Y.max,E[D]=P=!0}}if(P){x.forEach((D,H)=>{s==2?H>0&&E.y&&(D._paths=null):E[D.scale]&&(D._paths=null)});for(let D in E)ve=!0,In("setScale",D);ge&&de.left>=0&&(ee=me=!0)}for(let D in G)G[D]=null}function Ve(v){let E=pf(an-1,0,nn-1),P=pf(ln+1,0,nn-1);for(;v[E]==null&&E>0;)E--;for(;v[P]==null&&P<nn-1;)P++;return[E,P]}function _t(){if(nn>0){let v=x.some(E=>E._focus)&&De!=ze.alpha;v&&(u.globalAlpha=De=ze.alpha),x.forEach((E,P)=>{if(P>0&&E.show&&(Qt(P,!1),Qt(P,!0),E._paths==null)){let D=De;De!=E.alpha&&(u.globalAlpha=De=E.alpha);let H=s==2?[0,e[P][0].length-1]:Ve(e[P]);E._paths=E.paths(n,P,H[0],H[1]),De!=D&&(u.globalAlpha=De=D)}}),x.forEach((E,P)=>{if(P>0&&E.show){let D=De;De!=E.alpha&&(u.globalAlpha=De=E.alpha),E._paths!=null&&Ot(P,!1);{let H=E._paths!=null?E._paths.gaps:null,Y=E.points.show(n,P,an,ln,H),ae=E.points.filter(n,P,Y,H);(Y||ae)&&(E.points._paths=E.points.paths(n,P,an,ln,ae),Ot(P,!0))}De!=D&&(u.globalAlpha=De=D),In("drawSeries",P)}}),v&&(u.globalAlpha=De=1)}}function Qt(v,E){let P=E?x[v].points:x[v];P._stroke=P.stroke(n,v),P._fill=P.fill(n,v)}function Ot(v,E){let P=E?x[v].points:x[v],{stroke:D,fill:H,clip:Y,flags:ae,_stroke:pe=P._stroke,_fill:be=P._fill,_width:Ue=P.width}=P._paths;Ue=Gt(Ue*Rt,3);let Fe=null,Be=Ue%2/2;E&&be==null&&(be=Ue>0?"#fff":pe);let rt=P.pxAlign==1&&Be>0;if(rt&&u.translate(Be,Be),!E){let Ct=R-Ue/2,Tt=w-Ue/2,xt=$+Ue,Je=he+Ue;Fe=new Path2D,Fe.rect(Ct,Tt,xt,Je)}E?ke(pe,Ue,P.dash,P.cap,be,D,H,ae,Y):Ut(v,pe,Ue,P.dash,P.cap,be,D,H,ae,Fe,Y),rt&&u.translate(-Be,-Be)}function Ut(v,E,P,D,H,Y,ae,pe,be,Ue,Fe){let Be=!1;be!=0&&A.forEach((rt,Ct)=>{if(rt.series[0]==v){let Tt=x[rt.series[1]],xt=e[rt.series[1]],Je=(Tt._paths||Oa).band;Zs(Je)&&(Je=rt.dir==1?Je[0]:Je[1]);let Ye,Xt=null;Tt.show&&Je&&UM(xt,an,ln)?(Xt=rt.fill(n,Ct)||Y,Ye=Tt._paths.clip):Je=null,ke(E,P,D,H,Xt,ae,pe,be,Ue,Fe,Ye,Je),Be=!0}}),Be||ke(E,P,D,H,Y,ae,pe,be,Ue,Fe)}let xn=po|_f;function ke(v,E,P,D,H,Y,ae,pe,be,Ue,Fe,Be){Ce(v,E,P,D,H),(be||Ue||Be)&&(u.save(),be&&u.clip(be),Ue&&u.clip(Ue)),Be?(pe&xn)==xn?(u.clip(Be),Fe&&u.clip(Fe),vt(H,ae),dn(v,Y,E)):pe&_f?(vt(H,ae),u.clip(Be),dn(v,Y,E)):pe&po&&(u.save(),u.clip(Be),Fe&&u.clip(Fe),vt(H,ae),u.restore(),dn(v,Y,E)):(vt(H,ae),dn(v,Y,E)),(be||Ue||Be)&&u.restore()}function dn(v,E,P){P>0&&(E instanceof Map?E.forEach((D,H)=>{u.strokeStyle=qr=H,u.stroke(D)}):E!=null&&v&&u.stroke(E))}function vt(v,E){E instanceof Map?E.forEach((P,D)=>{u.fillStyle=Gs=D,u.fill(P)}):E!=null&&v&&u.fill(E)}function ms(v,E,P,D){let H=C[v],Y;if(D<=0)Y=[0,0];else{let ae=H._space=H.space(n,v,E,P,D),pe=H._incrs=H.incrs(n,v,E,P,D,ae);Y=iE(E,P,pe,D,ae)}return H._found=Y}function fn(v,E,P,D,H,Y,ae,pe,be,Ue){let Fe=ae%2/2;_==1&&u.translate(Fe,Fe),Ce(pe,ae,be,Ue,pe),u.beginPath();let Be,rt,Ct,Tt,xt=H+(D==0||D==3?-Y:Y);P==0?(rt=H,Tt=xt):(Be=H,Ct=xt);for(let Je=0;Je<v.length;Je++)E[Je]!=null&&(P==0?Be=Ct=v[Je]:rt=Tt=v[Je],u.moveTo(Be,rt),u.lineTo(Ct,Tt));u.stroke(),_==1&&u.translate(-Fe,-Fe)}function Yr(v){let E=!0;return C.forEach((P,D)=>{if(!P.show)return;let H=b[P.scale];if(H.min==null){P._show&&(E=!1,P._show=!1,ft(!1));return}else P._show||(E=!1,P._show=!0,ft(!1));let Y=P.side,ae=Y%2,{min:pe,max:be}=H,[Ue,Fe]=ms(D,pe,be,ae==0?k:Le);if(Fe==0)return;let Be=H.distr==2,rt=P._splits=P.splits(n,D,pe,be,Ue,Fe,Be),Ct=H.distr==2?rt.map(Ye=>ri[Ye]):rt,Tt=H.distr==2?ri[rt[1]]-ri[rt[0]]:Ue,xt=P._values=P.values(n,P.filter(n,Ct,D,Fe,Tt),D,Fe,Tt);P._rotate=Y==2?P.rotate(n,xt,D,Fe):0;let Je=P._size;P._size=Ei(P.size(n,xt,D,v)),Je!=null&&P._size!=Je&&(E=!1)}),E}function Ki(v){let E=!0;return oa.forEach((P,D)=>{let H=P(n,D,ji,v);H!=Li[D]&&(E=!1),Li[D]=H}),E}function gs(){for(let v=0;v<C.length;v++){let E=C[v];if(!E.show||!E._show)continue;let P=E.side,D=P%2,H,Y,ae=E.stroke(n,v),pe=P==0||P==3?-1:1,[be,Ue]=E._found;if(E.label!=null){let $n=E.labelGap*pe,li=bn((E._lpos+$n)*Rt);Ne(E.labelFont[0],ae,"center",P==2?"top":q0),u.save(),D==1?(H=Y=0,u.translate(li,bn(w+he/2)),u.rotate((P==3?-Ac:Ac)/2)):(H=bn(R+$/2),Y=li);let _r=O_(E.label)?E.label(n,v,be,Ue):E.label;u.fillText(_r,H,Y),u.restore()}if(Ue==0)continue;let Fe=b[E.scale],Be=D==0?$:he,rt=D==0?R:w,Ct=E._splits,Tt=Fe.distr==2?Ct.map($n=>ri[$n]):Ct,xt=Fe.distr==2?ri[Ct[1]]-ri[Ct[0]]:be,Je=E.ticks,Ye=E.border,Xt=Je.show?Je.size:0,rn=bn(Xt*Rt),Ln=bn((E.alignTo==2?E._size-Xt-E.gap:E.gap)*Rt),Bt=E._rotate*-Ac/180,on=m(E._pos*Rt),oi=(rn+Ln)*pe,Wn=on+oi;Y=D==0?Wn:0,H=D==1?Wn:0;let Si=E.font[0],Di=E.align==1?ao:E.align==2?nf:Bt>0?ao:Bt<0?nf:D==0?"center":P==3?nf:ao,es=Bt||D==1?"middle":P==2?"top":q0;Ne(Si,ae,Di,es);let ai=E.font[1]*E.lineGap,Mi=Ct.map($n=>m(a($n,Fe,Be,rt))),Ni=E._values;for(let $n=0;$n<Ni.length;$n++){let li=Ni[$n];if(li!=null){D==0?H=Mi[$n]:Y=Mi[$n],li=""+li;let _r=li.indexOf(`
`)==-1?[li]:li.split(/\n/gm);for(let qn=0;qn<_r.length;qn++){let ag=_r[qn];Bt?(u.save(),u.translate(H,Y+qn*ai),u.rotate(Bt),u.fillText(ag,0,0),u.restore()):u.fillText(ag,H,Y+qn*ai)}}}Je.show&&fn(Mi,Je.filter(n,Tt,v,Ue,xt),D,P,on,rn,Gt(Je.width*Rt,3),Je.stroke(n,v),Je.dash,Je.cap);let ts=E.grid;ts.show&&fn(Mi,ts.filter(n,Tt,v,Ue,xt),D,D==0?2:1,D==0?w:R,D==0?he:$,Gt(ts.width*Rt,3),ts.stroke(n,v),ts.dash,ts.cap),Ye.show&&fn([on],[1],D==0?1:0,D==0?1:2,D==1?w:R,D==1?he:$,Gt(Ye.width*Rt,3),Ye.stroke(n,v),Ye.dash,Ye.cap)}In("drawAxes")}function ft(v){x.forEach((E,P)=>{P>0&&(E._paths=null,v&&(s==1?(E.min=null,E.max=null):E.facets.forEach(D=>{D.min=null,D.max=null})))})}let sn=!1,Hn=!1,Ft=[];function pn(){Hn=!1;for(let v=0;v<Ft.length;v++)In(...Ft[v]);Ft.length=0}function kn(){sn||(ZM(Hm),sn=!0)}function zl(v,E=!1){sn=!0,Hn=E,v(n),Hm(),E&&Ft.length>0&&queueMicrotask(pn)}n.batch=zl;function Hm(){if(oe&&(gt(),oe=!1),ve&&(Te(),ve=!1),ye){if(Yt(f,ao,Ke),Yt(f,"top",lt),Yt(f,Ia,k),Yt(f,La,Le),Yt(p,ao,Ke),Yt(p,"top",lt),Yt(p,Ia,k),Yt(p,La,Le),Yt(d,Ia,tn),Yt(d,La,un),h.width=bn(tn*Rt),h.height=bn(un*Rt),C.forEach(({_el:v,_show:E,_size:P,_pos:D,side:H})=>{if(v!=null)if(E){let Y=H===3||H===0?P:0,ae=H%2==1;Yt(v,ae?"left":"top",D-Y),Yt(v,ae?"width":"height",P),Yt(v,ae?"top":"left",ae?lt:Ke),Yt(v,ae?"height":"width",ae?Le:k),df(v,Rr)}else ui(v,Rr)}),qr=Gs=Xr=B=K=q=X=Ae=T=null,De=1,ua(!0),Ke!=Ee||lt!=zt||k!=We||Le!=je){ft(!1);let v=k/We,E=Le/je;if(ge&&!ee&&de.left>=0){de.left*=v,de.top*=E,jr&&ss(jr,bn(de.left),0,k,Le),Zr&&ss(Zr,0,bn(de.top),k,Le);for(let P=0;P<ct.length;P++){let D=ct[P];D!=null&&(Wt[P]*=v,Gn[P]*=E,ss(D,Ei(Wt[P]),Ei(Gn[P]),k,Le))}}if(qt.show&&!ne&&qt.left>=0&&qt.width>0){qt.left*=v,qt.width*=v,qt.top*=E,qt.height*=E;for(let P in Sd)Yt(Qr,P,qt[P])}Ee=Ke,zt=lt,We=k,je=Le}In("setSize"),ye=!1}tn>0&&un>0&&(u.clearRect(0,0,h.width,h.height),In("drawClear"),M.forEach(v=>v()),In("draw")),qt.show&&ne&&(Vl(qt),ne=!1),ge&&ee&&(gr(null,!0,!1),ee=!1),fe.show&&fe.live&&me&&(vd(),me=!1),l||(l=!0,n.status=1,In("ready")),Vs=!1,sn=!1}n.redraw=(v,E)=>{ve=E||!1,v!==!1?Ws(S,L.min,L.max):kn()};function _d(v,E){let P=b[v];if(P.from==null){if(nn==0){let D=P.range(n,E.min,E.max,v);E.min=D[0],E.max=D[1]}if(E.min>E.max){let D=E.min;E.min=E.max,E.max=D}if(nn>1&&E.min!=null&&E.max!=null&&E.max-E.min<1e-16)return;v==S&&P.distr==2&&nn>0&&(E.min=Fi(E.min,e[0]),E.max=Fi(E.max,e[0]),E.min==E.max&&E.max++),G[v]=E,oe=!0,kn()}}n.setScale=_d;let yd,xd,jr,Zr,Wm,$m,Kr,Jr,qm,Xm,$t,Kt,Hs=!1,Un=de.drag,Rn=Un.x,Pn=Un.y;ge&&(de.x&&(yd=wi(vM,p)),de.y&&(xd=wi(bM,p)),L.ori==0?(jr=yd,Zr=xd):(jr=xd,Zr=yd),$t=de.left,Kt=de.top);let qt=n.select=gn({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),Qr=qt.show?wi(xM,qt.over?p:f):null;function Vl(v,E){if(qt.show){for(let P in v)qt[P]=v[P],P in Sd&&Yt(Qr,P,v[P]);E!==!1&&In("setSelect")}}n.setSelect=Vl;function Db(v){if(x[v].show)Q&&df(at[v],Rr);else if(Q&&ui(at[v],Rr),ge){let P=Ie?ct[0]:ct[v];P!=null&&ss(P,-10,-10,k,Le)}}function Ws(v,E,P){_d(v,{min:E,max:P})}function Ji(v,E,P,D){E.focus!=null&&kb(v),E.show!=null&&x.forEach((H,Y)=>{Y>0&&(v==Y||v==null)&&(H.show=E.show,Db(Y),s==2?(Ws(H.facets[0].scale,null,null),Ws(H.facets[1].scale,null,null)):Ws(H.scale,null,null),kn())}),P!==!1&&In("setSeries",v,E),D&&da("setSeries",n,v,E)}n.setSeries=Ji;function Nb(v,E){gn(A[v],E)}function Ob(v,E){v.fill=bt(v.fill||null),v.dir=At(v.dir,-1),E=E??A.length,A.splice(E,0,v)}function Ub(v){v==null?A.length=0:A.splice(v,1)}n.addBand=Ob,n.setBand=Nb,n.delBand=Ub;function Fb(v,E){x[v].alpha=E,ge&&ct[v]!=null&&(ct[v].style.opacity=E),Q&&at[v]&&(at[v].style.opacity=E)}let _s,$s,mr,eo={focus:!0};function kb(v){if(v!=mr){let E=v==null,P=ze.alpha!=1;x.forEach((D,H)=>{if(s==1||H>0){let Y=E||H==0||H==v;D._focus=E?null:Y,P&&Fb(H,Y?1:ze.alpha)}}),mr=v,P&&kn()}}Q&&tt&&wt(Z0,Pe,v=>{de._lock||(et(v),mr!=null&&Ji(null,eo,!0,mn.setSeries))});function Qi(v,E,P){let D=b[E];P&&(v=v/Rt-(D.ori==1?lt:Ke));let H=k;D.ori==1&&(H=Le,v=H-v),D.dir==-1&&(v=H-v);let Y=D._min,ae=D._max,pe=v/H,be=Y+(ae-Y)*pe,Ue=D.distr;return Ue==3?ho(10,be):Ue==4?kM(be,D.asinh):Ue==100?D.bwd(be):be}function Bb(v,E){let P=Qi(v,S,E);return Fi(P,e[0],an,ln)}n.valToIdx=v=>Fi(v,e[0]),n.posToIdx=Bb,n.posToVal=Qi,n.valToPos=(v,E,P)=>b[E].ori==0?r(v,b[E],P?$:k,P?R:0):o(v,b[E],P?he:Le,P?w:0),n.setCursor=(v,E,P)=>{$t=v.left,Kt=v.top,gr(null,E,P)};function Ym(v,E){Yt(Qr,ao,qt.left=v),Yt(Qr,Ia,qt.width=E)}function jm(v,E){Yt(Qr,"top",qt.top=v),Yt(Qr,La,qt.height=E)}let ca=L.ori==0?Ym:jm,ha=L.ori==1?Ym:jm;function zb(){if(Q&&fe.live)for(let v=s==2?1:0;v<x.length;v++){if(v==0&&dt)continue;let E=fe.values[v],P=0;for(let D in E)$e[v][P++].firstChild.nodeValue=E[D]}}function vd(v,E){if(v!=null&&(v.idxs?v.idxs.forEach((P,D)=>{ie[D]=P}):GM(v.idx)||ie.fill(v.idx),fe.idx=ie[0]),Q&&fe.live){for(let P=0;P<x.length;P++)(P>0||s==1&&!dt)&&Vb(P,ie[P]);zb()}me=!1,E!==!1&&In("setLegend")}n.setLegend=vd;function Vb(v,E){let P=x[v],D=v==0&&V==2?ri:e[v],H;dt?H=P.values(n,v,E)??st:(H=P.value(n,E==null?null:D[E],v,E),H=H==null?st:{_:H}),fe.values[v]=H}function gr(v,E,P){qm=$t,Xm=Kt,[$t,Kt]=de.move(n,$t,Kt),de.left=$t,de.top=Kt,ge&&(jr&&ss(jr,bn($t),0,k,Le),Zr&&ss(Zr,0,bn(Kt),k,Le));let D,H=an>ln;_s=Vt,$s=null;let Y=L.ori==0?k:Le,ae=L.ori==1?k:Le;if($t<0||nn==0||H){D=de.idx=null;for(let pe=0;pe<x.length;pe++){let be=ct[pe];be!=null&&ss(be,-10,-10,k,Le)}tt&&Ji(null,eo,!0,v==null&&mn.setSeries),fe.live&&(ie.fill(D),me=!0)}else{let pe,be,Ue;s==1&&(pe=L.ori==0?$t:Kt,be=Qi(pe,S),D=de.idx=Fi(be,e[0],an,ln),Ue=W(e[0][D],L,Y,0));let Fe=-10,Be=-10,rt=0,Ct=0,Tt=!0,xt="",Je="";for(let Ye=s==2?1:0;Ye<x.length;Ye++){let Xt=x[Ye],rn=ie[Ye],Ln=rn==null?null:s==1?e[Ye][rn]:e[Ye][1][rn],Bt=de.dataIdx(n,Ye,D,be),on=Bt==null?null:s==1?e[Ye][Bt]:e[Ye][1][Bt];if(me=me||on!=Ln||Bt!=rn,ie[Ye]=Bt,Ye>0&&Xt.show){let oi=Bt==null?-10:Bt==D?Ue:W(s==1?e[0][Bt]:e[Ye][0][Bt],L,Y,0),Wn=on==null?-10:O(on,s==1?b[Xt.scale]:b[Xt.facets[1].scale],ae,0);if(tt&&on!=null){let Si=L.ori==1?$t:Kt,Di=Sn(ze.dist(n,Ye,Bt,Wn,Si));if(Di<_s){let es=ze.bias;if(es!=0){let ai=Qi(Si,Xt.scale),Mi=on>=0?1:-1,Ni=ai>=0?1:-1;Ni==Mi&&(Ni==1?es==1?on>=ai:on<=ai:es==1?on<=ai:on>=ai)&&(_s=Di,$s=Ye)}else _s=Di,$s=Ye}}if(me||Ie){let Si,Di;L.ori==0?(Si=oi,Di=Wn):(Si=Wn,Di=oi);let es,ai,Mi,Ni,ts,$n,li=!0,_r=le.bbox;if(_r!=null){li=!1;let qn=_r(n,Ye);Mi=qn.left,Ni=qn.top,es=qn.width,ai=qn.height}else Mi=Si,Ni=Di,es=ai=le.size(n,Ye);if($n=le.fill(n,Ye),ts=le.stroke(n,Ye),Ie)Ye==$s&&_s<=ze.prox&&(Fe=Mi,Be=Ni,rt=es,Ct=ai,Tt=li,xt=$n,Je=ts);else{let qn=ct[Ye];qn!=null&&(Wt[Ye]=Mi,Gn[Ye]=Ni,i_(qn,es,ai,li),t_(qn,$n,ts),ss(qn,Ei(Mi),Ei(Ni),k,Le))}}}}if(Ie){let Ye=ze.prox,Xt=mr==null?_s<=Ye:_s>Ye||$s!=mr;if(me||Xt){let rn=ct[0];rn!=null&&(Wt[0]=Fe,Gn[0]=Be,i_(rn,rt,Ct,Tt),t_(rn,xt,Je),ss(rn,Ei(Fe),Ei(Be),k,Le))}}}if(qt.show&&Hs)if(v!=null){let[pe,be]=mn.scales,[Ue,Fe]=mn.match,[Be,rt]=v.cursor.sync.scales,Ct=v.cursor.drag;if(Rn=Ct._x,Pn=Ct._y,Rn||Pn){let{left:Tt,top:xt,width:Je,height:Ye}=v.select,Xt=v.scales[Be].ori,rn=v.posToVal,Ln,Bt,on,oi,Wn,Si=pe!=null&&Ue(pe,Be),Di=be!=null&&Fe(be,rt);Si&&Rn?(Xt==0?(Ln=Tt,Bt=Je):(Ln=xt,Bt=Ye),on=b[pe],oi=W(rn(Ln,Be),on,Y,0),Wn=W(rn(Ln+Bt,Be),on,Y,0),ca(ki(oi,Wn),Sn(Wn-oi))):ca(0,Y),Di&&Pn?(Xt==1?(Ln=Tt,Bt=Je):(Ln=xt,Bt=Ye),on=b[be],oi=O(rn(Ln,rt),on,ae,0),Wn=O(rn(Ln+Bt,rt),on,ae,0),ha(ki(oi,Wn),Sn(Wn-oi))):ha(0,ae)}else Md()}else{let pe=Sn(qm-Wm),be=Sn(Xm-$m);if(L.ori==1){let rt=pe;pe=be,be=rt}Rn=Un.x&&pe>=Un.dist,Pn=Un.y&&be>=Un.dist;let Ue=Un.uni;Ue!=null?Rn&&Pn&&(Rn=pe>=Ue,Pn=be>=Ue,!Rn&&!Pn&&(be>pe?Pn=!0:Rn=!0)):Un.x&&Un.y&&(Rn||Pn)&&(Rn=Pn=!0);let Fe,Be;Rn&&(L.ori==0?(Fe=Kr,Be=$t):(Fe=Jr,Be=Kt),ca(ki(Fe,Be),Sn(Be-Fe)),Pn||ha(0,ae)),Pn&&(L.ori==1?(Fe=Kr,Be=$t):(Fe=Jr,Be=Kt),ha(ki(Fe,Be),Sn(Be-Fe)),Rn||ca(0,Y)),!Rn&&!Pn&&(ca(0,0),ha(0,0))}if(Un._x=Rn,Un._y=Pn,v==null){if(P){if(og!=null){let[pe,be]=mn.scales;mn.values[0]=pe!=null?Qi(L.ori==0?$t:Kt,pe):null,mn.values[1]=be!=null?Qi(L.ori==1?$t:Kt,be):null}da(sf,n,$t,Kt,k,Le,D)}if(tt){let pe=P&&mn.setSeries,be=ze.prox;mr==null?_s<=be&&Ji($s,eo,!0,pe):_s>be?Ji(null,eo,!0,pe):$s!=mr&&Ji($s,eo,!0,pe)}}me&&(fe.idx=D,vd()),E!==!1&&In("setCursor")}let qs=null;Object.defineProperty(n,"rect",{get(){return qs==null&&ua(!1),qs}});function ua(v=!1){v?qs=null:(qs=p.getBoundingClientRect(),In("syncRect",qs))}function Zm(v,E,P,D,H,Y,ae){de._lock||Hs&&v!=null&&v.movementX==0&&v.movementY==0||(bd(v,E,P,D,H,Y,ae,!1,v!=null),v!=null?gr(null,!0,!0):gr(E,!0,!1))}function bd(v,E,P,D,H,Y,ae,pe,be){if(qs==null&&ua(!1),et(v),v!=null)P=v.clientX-qs.left,D=v.clientY-qs.top;else{if(P<0||D<0){$t=-10,Kt=-10;return}let[Ue,Fe]=mn.scales,Be=E.cursor.sync,[rt,Ct]=Be.values,[Tt,xt]=Be.scales,[Je,Ye]=mn.match,Xt=E.axes[0].side%2==1,rn=L.ori==0?k:Le,Ln=L.ori==1?k:Le,Bt=Xt?Y:H,on=Xt?H:Y,oi=Xt?D:P,Wn=Xt?P:D;if(Tt!=null?P=Je(Ue,Tt)?a(rt,b[Ue],rn,0):-10:P=rn*(oi/Bt),xt!=null?D=Ye(Fe,xt)?a(Ct,b[Fe],Ln,0):-10:D=Ln*(Wn/on),L.ori==1){let Si=P;P=D,D=Si}}be&&(E==null||E.cursor.event.type==sf)&&((P<=1||P>=k-1)&&(P=Ar(P,k)),(D<=1||D>=Le-1)&&(D=Ar(D,Le))),pe?(Wm=P,$m=D,[Kr,Jr]=de.move(n,P,D)):($t=P,Kt=D)}let Sd={width:0,height:0,left:0,top:0};function Md(){Vl(Sd,!1)}let Km,Jm,Qm,eg;function tg(v,E,P,D,H,Y,ae){Hs=!0,Rn=Pn=Un._x=Un._y=!1,bd(v,E,P,D,H,Y,ae,!0,!1),v!=null&&(wt(rf,hf,ng,!1),da(Y0,n,Kr,Jr,k,Le,null));let{left:pe,top:be,width:Ue,height:Fe}=qt;Km=pe,Jm=be,Qm=Ue,eg=Fe}function ng(v,E,P,D,H,Y,ae){Hs=Un._x=Un._y=!1,bd(v,E,P,D,H,Y,ae,!1,!0);let{left:pe,top:be,width:Ue,height:Fe}=qt,Be=Ue>0||Fe>0,rt=Km!=pe||Jm!=be||Qm!=Ue||eg!=Fe;if(Be&&rt&&Vl(qt),Un.setScale&&Be&&rt){let Ct=pe,Tt=Ue,xt=be,Je=Fe;if(L.ori==1&&(Ct=be,Tt=Fe,xt=pe,Je=Ue),Rn&&Ws(S,Qi(Ct,S),Qi(Ct+Tt,S)),Pn)for(let Ye in b){let Xt=b[Ye];Ye!=S&&Xt.from==null&&Xt.min!=Vt&&Ws(Ye,Qi(xt+Je,Ye),Qi(xt,Ye))}Md()}else de.lock&&(de._lock=!de._lock,gr(E,!0,v!=null));v!=null&&(yn(rf,hf),da(rf,n,$t,Kt,k,Le,null))}function Gb(v,E,P,D,H,Y,ae){if(de._lock)return;et(v);let pe=Hs;if(Hs){let be=!0,Ue=!0,Fe=10,Be,rt;L.ori==0?(Be=Rn,rt=Pn):(Be=Pn,rt=Rn),Be&&rt&&(be=$t<=Fe||$t>=k-Fe,Ue=Kt<=Fe||Kt>=Le-Fe),Be&&be&&($t=$t<Kr?0:k),rt&&Ue&&(Kt=Kt<Jr?0:Le),gr(null,!0,!0),Hs=!1}$t=-10,Kt=-10,ie.fill(null),gr(null,!0,!0),pe&&(Hs=pe)}function ig(v,E,P,D,H,Y,ae){de._lock||(et(v),la(),Md(),v!=null&&da(K0,n,$t,Kt,k,Le,null))}function sg(){C.forEach(sE),F(n.width,n.height,!0)}Pr(Cc,co,sg);let to={};to.mousedown=tg,to.mousemove=Zm,to.mouseup=ng,to.dblclick=ig,to.setSeries=(v,E,P,D)=>{let H=mn.match[2];P=H(n,E,P),P!=-1&&Ji(P,D,!0,!1)},ge&&(wt(Y0,p,tg),wt(sf,p,Zm),wt(j0,p,v=>{et(v),ua(!1)}),wt(Z0,p,Gb),wt(K0,p,ig),yf.add(n),n.syncRect=ua);let Gl=n.hooks=i.hooks||{};function In(v,E,P){Hn?Ft.push([v,E,P]):v in Gl&&Gl[v].forEach(D=>{D.call(null,n,E,P)})}(i.plugins||[]).forEach(v=>{for(let E in v.hooks)Gl[E]=(Gl[E]||[]).concat(v.hooks[E])});let rg=(v,E,P)=>P,mn=gn({key:null,setSeries:!1,filters:{pub:l_,sub:l_},scales:[S,x[1]?x[1].scale:null],match:[c_,c_,rg],values:[null,null]},de.sync);mn.match.length==2&&mn.match.push(rg),de.sync=mn;let og=mn.key,wd=ry(og);function da(v,E,P,D,H,Y,ae){mn.filters.pub(v,E,P,D,H,Y,ae)&&wd.pub(v,E,P,D,H,Y,ae)}wd.sub(n);function Hb(v,E,P,D,H,Y,ae){mn.filters.sub(v,E,P,D,H,Y,ae)&&to[v](null,E,P,D,H,Y,ae)}n.pub=Hb;function Wb(){wd.unsub(n),yf.delete(n),Cn.clear(),ff(Cc,co,sg),c.remove(),Pe?.remove(),In("destroy")}n.destroy=Wb;function Ed(){In("init",i,e),aa(e||i.data,!1),G[S]?_d(S,G[S]):la(),ne=qt.show&&(qt.width>0||qt.height>0),ee=me=!0,F(i.width,i.height)}return x.forEach($r),C.forEach(fs),t?t instanceof HTMLElement?(t.appendChild(c),Ed()):t(n,Ed):Ed(),n}Fn.assign=gn;Fn.fmtNum=Ef;Fn.rangeNum=Rc;Fn.rangeLog=Lc;Fn.rangeAsinh=Mf;Fn.orient=Lr;Fn.pxRatio=Rt;Fn.join=jM;Fn.fmtDate=Af,Fn.tzDate=ow;Fn.sync=ry;{Fn.addGap=Gw,Fn.clipGaps=Oc;let i=Fn.paths={points:uy};i.linear=fy,i.stepped=$w,i.bars=qw,i.spline=Yw}var Bc=5,oE=7,aE=3,lE=4,cE={ArrowUp:1.01,ArrowDown:1/1.01,PageUp:1.1,PageDown:1/1.1},zc=class{constructor(e,t){this.moves=t;this.layer=document.createElement("div");this.handles=new Map;this.sizes=new Map;this.before=new Map;this.plot=null;this.layer.className="limits",e.append(this.layer)}place(e,t,n,s){this.plot=e;let r=new Set(t.map(_=>_.id)),{left:o,top:a,width:l,height:c}=_y(e);for(let[_,m]of this.handles)r.has(_)||(m.remove(),this.handles.delete(_));Object.assign(this.layer.style,{left:`${o}px`,top:`${a}px`,width:`${l}px`,height:`${c}px`});let h=[...t].sort((_,m)=>_.y-m.y).flatMap(_=>{let m=this.handles.get(_.id)??this.made(_.id),g=this.put(m,_);return g?[{limit:_,handle:m,...g}]:[]}),u=_=>h.map(({limit:m,handle:g,...x})=>({...x,size:this.sizeOf(g,m[_],m.violated),before:this.before.get(`${m.id} ${_}`)})),d="label",f=u(d),p=Yd(f,{width:l,height:c},n,h.length>aE?1:2,s);p.includes(null)&&(f=u(d="short"),p=Yd(f,{width:l,height:c},n,lE,s)),this.before=new Map(h.flatMap(({limit:_},m)=>p[m]?[[`${_.id} ${d}`,p[m].number]]:[])),h.forEach(({limit:_,handle:m},g)=>this.label(m,_[d],f[g],p[g]))}put(e,t){let n=this.plot,{width:s,height:r}=_y(n),o=m=>Math.min(Math.max(n.valToPos(m,"x"),0),s),a=o(t.from),l=Number.isFinite(t.to)?o(t.to):s,c=n.valToPos(t.y,"y"),h=n.valToPos(t.from,"x")<=s&&!(n.valToPos(t.to,"x")<0),u=!(h&&c>=0&&c<=r);if(e.hidden=u,u)return null;e.classList.toggle("violated",t.violated&&t.binding),e.classList.toggle("unbinding",t.violated&&!t.binding),e.classList.toggle("fixed",!t.movable);let d={"aria-label":`Limit of ${t.result}`,"aria-valuenow":String(t.y),"aria-valuetext":t.words,"aria-orientation":"vertical","aria-disabled":String(!t.movable),title:t.words};for(let[m,g]of Object.entries(d))e.setAttribute(m,g);Object.assign(e.style,{left:`${a}px`,width:`${Math.max(l-a,2*Bc)}px`,top:`${c-Bc}px`,height:`${2*Bc}px`});let{dash:[f=1,p=0]}=t,_=Math.min(oE/(f+p),1);for(let[m,g]of Object.entries({"--stroke":t.colour,"--on":`${_*f}px`,"--period":`${_*(f+p)}px`}))e.style.setProperty(m,g);return{left:a,right:l,top:c}}label(e,t,{left:n,right:s,top:r,size:o},a){let l=e.firstElementChild;l.textContent!==t&&(l.textContent=t),l.classList.toggle("unseen",!a);let[c,h]=a?.box??[Math.max(n,s-o),Math.max(r-15,0)];Object.assign(l.style,{left:`${c-n}px`,top:`${h-r+Bc}px`})}sizeOf(e,t,n){let s=`${n} ${t.replace(/\d/g,"0")}`,r=this.sizes.get(s);if(r!==void 0)return r;let o=e.firstElementChild;o.textContent=t,o.classList.remove("unseen");let a=o.offsetWidth;return a>0&&this.sizes.set(s,a),a}made(e){let t=document.createElement("div"),n=document.createElement("span");t.className="limit",t.tabIndex=0,t.setAttribute("role","slider"),t.append(n);let s=()=>t.classList.contains("fixed");return t.addEventListener("pointerdown",r=>{if(s()||r.button!==0)return;let o=r.clientY,a=this.plot.valToPos(Number(t.getAttribute("aria-valuenow")),"y"),l=c=>this.moves.moved(e,this.plot.posToVal(Math.min(Math.max(a+c.clientY-o,0),this.plot.over.clientHeight),"y"));t.setPointerCapture(r.pointerId),t.addEventListener("pointermove",l),t.addEventListener("lostpointercapture",()=>{t.removeEventListener("pointermove",l),this.moves.dropped(e)},{once:!0}),this.moves.began(),t.focus(),r.preventDefault()}),t.addEventListener("click",r=>r.stopPropagation()),t.addEventListener("keydown",r=>{let o=cE[r.key];!o||s()||r.ctrlKey||r.metaKey||(this.moves.stepped(e,o),r.preventDefault(),r.stopPropagation())}),this.layer.append(t),this.handles.set(e,t),t}};function _y({bbox:i}){let e=devicePixelRatio;return{left:i.left/e,top:i.top/e,width:i.width/e,height:i.height/e}}function xy(i,e=[]){let[t,n]=yy(i),s=n>0?[...e].filter(l=>l!==null&&l>=1e-5*n&&l<=n/1e-5):e,[r,o]=yy(s),a=Math.max(n,o);return a>0?[Math.max(Math.min(t,r),1e-5*(n||o))/1.3,a*2]:[1e-5,1]}function yy(i){let[e,t]=[1/0,0];for(let n of i)n!==null&&n>0&&Number.isFinite(n)&&([e,t]=[Math.min(e,n),Math.max(t,n)]);return[e,t]}function Of(i,e){if(!(i>0&&e>i&&Number.isFinite(e)))return{lines:[],labelled:[]};let t=Nf(i,e,[1]),n=e/i<300||t.length<2?Nf(i,e,[1,2,5]):t,s=n.length<3?hE(i,e):n;return{lines:e/i>1e8||n.length<3?s:Nf(i,e,[1,2,3,4,5,6,7,8,9]),labelled:s}}function Nf(i,e,t){let[n,s]=[Math.floor(Math.log10(i)),Math.ceil(Math.log10(e))],r=1+Math.floor((s-n)/12),o=[];for(let a=n;a<=s;a+=r)for(let l of t)o.push(+`${l}e${a}`);return o.filter(a=>a>=i*(1-1e-9)&&a<=e*(1+1e-9))}function hE(i,e){let t=(e-i)/5,n=10**Math.floor(Math.log10(t)),s=n*([1,2,5].find(a=>a*n>=t)??10),r=Math.ceil(i/s-1e-9),o=Math.floor((e-r*s)/s+1e-9);return Array.from({length:o+1},(a,l)=>Number(((r+l)*s).toPrecision(12)))}function vy(i,e,t){let n=[],s=[],r=()=>{s.length>1&&n.push(s),s=[]};for(let o=0;o<i.length;o++){let a=e[o]??null,l=o>0?e[o-1]??null:null,c=()=>i[o-1]+(i[o]-i[o-1])*(t-l)/(a-l);a!==null&&a>t?(!s.length&&l!==null&&s.push([c(),t]),s.push([i[o],a])):(s.length&&a!==null&&s.push([c(),t]),r())}return r(),n}var uE=16,dE=4,fE=2.6,by=7,pE=18,Uf=16;function mE(i,e){let t=i.flatMap(({unbounded:s,stroke:r})=>s.map(o=>({x:o,y:null,stroke:r}))),n=i.flatMap(({peaks:s,stroke:r})=>s.map(o=>({...o,stroke:r}))).sort((s,r)=>r.y-s.y);return[...t,...[...k0(e),...n].slice(0,uE)]}function Sy({ctx:i,bbox:e,valToPos:t},n,s){let r=devicePixelRatio,o=dE*r,a=[],l=e.left+e.width,c=mE(n,s).map(({x:h,y:u,stroke:d})=>({left:t(h,"x",!0),top:u===null?e.top+Uf*r:t(u,"y",!0),stroke:d,text:u===null?"∞":He(u,3),middle:null})).filter(({left:h,top:u})=>h>=e.left&&h<=l&&u>=e.top&&u<=e.top+e.height);for(let{left:h,top:u}of c)a.push([h-o,u-o,h+o,u+o]);i.font=wy(r);for(let h of c){let{left:u,top:d}=h,f=i.measureText(h.text).width/2;for(let p of[u,u+f+o,u-f-o]){let _=Math.min(Math.max(p,e.left+f),l-f),m=[_-f-3,d-pE*r,_+f+3,d-o];if(!a.some(g=>ro(g,m))){a.push(m),h.middle=_;break}}}return{peaks:c,taken:a}}function My(i,{peaks:e},t,{text:n,back:s}){let r=devicePixelRatio;for(let{left:o,top:a,stroke:l}of e)i.fillStyle=t(l),i.beginPath(),i.arc(o,a,fE*r,0,7),i.fill();[i.textAlign,i.fillStyle,i.strokeStyle,i.lineWidth,i.lineJoin]=["center",n,s,3*r,"round"];for(let{middle:o,top:a,text:l}of e)o!==null&&(i.font=wy(r,l==="∞"?16:11),i.strokeText(l,o,a-by*r),i.fillText(l,o,a-by*r))}var wy=(i,e=11)=>`${e*i}px system-ui, sans-serif`;var Vc=class{constructor(e){this.pen=e;this.from=null;this.last=[0,0];this.slopes=[0,0]}add(e,t){if(!this.from){this.pen.moveTo(e,t),this.begin(e,t);return}this.last!==this.from&&!this.isPassed(e,t)&&(this.pen.lineTo(...this.last),this.begin(...this.last));let n=e-this.from[0];this.slopes=[Math.max(this.slopes[0],(t-.15-this.from[1])/n),Math.min(this.slopes[1],(t+.15-this.from[1])/n)],this.last=[e,t]}end(){this.from&&this.last!==this.from&&this.pen.lineTo(...this.last),this.from=null}begin(e,t){this.from=this.last=[e,t],this.slopes=[-1/0,1/0]}isPassed(e,t){let n=(t-this.from[1])/(e-this.from[0]);return n>=this.slopes[0]&&n<=this.slopes[1]}};var Ff=1.6,gE=.3,Fa=class{constructor(e,t,n,s,r=null){this.parent=e;this.what=t;this.display=n;this.clicked=s;this.plot=null;this.picture=null;this.made="";this.peaks=null;this.held=null;this.handles=r&&new zc(e,{...r,began:()=>{let{min:o,max:a}=this.plot.scales.y;this.held=[o,a],r.began()},dropped:o=>{this.held=null,r.dropped(o),this.rescale()}})}show(e){this.picture=e;let{display:t,what:n}=this,{theme:s,frequencyUnit:r,logarithmicFrequency:o,logarithmicAmplitude:a,decibel:l}=t,c=e.curves.map(d=>`${d.name} ${d.stroke}`),h=JSON.stringify([s,r,o,a,l,c,e.scale.unit]),u=[e.x,...e.curves.map(d=>n==="phase"?d.phase:d.amplitude)];h===this.made&&this.plot?this.plot.setData(u):(this.plot?.destroy(),this.plot=new Fn(this.options(),u,this.parent),this.made=h)}resize(){let{clientWidth:e,clientHeight:t}=this.parent;e>0&&t>0&&this.plot?.setSize({width:e,height:t})}rescale(){this.plot?.setData(this.plot.data)}redraw(){this.plot?.redraw(!1)}destroy(){this.plot?.destroy()}options(){let{display:e,what:t,picture:n}=this,s=bs(e.theme),r=t==="phase",o=!r&&e.logarithmicAmplitude&&!e.decibel,a={stroke:s.axis,grid:{stroke:s.grid,width:1},ticks:{stroke:s.grid,width:1},font:"11px system-ui, sans-serif",labelFont:"12px system-ui, sans-serif",labelSize:16},l=(u,d)=>d.map(f=>f===null?"":He(f,6)),c={splits:(u,d,f,p)=>Of(f,p).lines,filter:(u,d)=>d,values:(u,d,f)=>{let{min:p,max:_}=u.scales[u.axes[f].scale],{labelled:m}=Of(p,_);return d.map(g=>m.includes(g)?He(g,6):"")}},h=e.logarithmicFrequency?{distr:3,range:(u,d,f)=>[d,f]}:{distr:1};return{width:Math.max(this.parent.clientWidth,50),height:Math.max(this.parent.clientHeight,50),padding:[r?4:14,10,0,0],legend:{show:!1},cursor:{y:!1,drag:{x:!0,y:!1},points:{show:!1},lock:!1},scales:{x:{time:!1,...h},y:r?{range:[-190,190]}:{distr:o?3:1,range:(u,d,f)=>this.range(d,f,o)}},axes:[{...a,size:r?34:20,values:l,...e.logarithmicFrequency?c:{},...r?{label:`frequency [${e.frequencyUnit}]`}:{values:(u,d)=>d.map(()=>"")}},{...a,size:46,label:r?"phase [°]":e.decibel?`dB re 1 ${n.scale.unit}`:n.scale.unit,...o?c:{values:l},...r?{splits:()=>[-180,-90,0,90,180]}:{}}],series:[{},...n.curves.map(u=>{let{colour:d,dash:f}=Xn(u.stroke,e.theme);return{label:u.name,stroke:d,dash:f,width:Ff,points:{show:!1},spanGaps:!1,paths:Ey(r?180:1/0)}})],hooks:{drawAxes:[u=>this.bands(u)],draw:[u=>this.marks(u)],ready:[u=>u.over.addEventListener("click",d=>this.clickedAt(u,d))]}}}range(e,t,n){if(this.held)return this.held;let{limits:s,overlays:r}=this.picture,o=r.flatMap(h=>[...h.points,...h.upper??[]].map(u=>u[1])).filter(h=>h!==null),a=[...s.map(h=>h.y),...s.flatMap(h=>h.at?[h.at.y]:[]),...o];if(n)return xy([e,t],a);let l=a.reduce((h,u)=>Math.max(h,u),t??1),c=a.reduce((h,u)=>Math.min(h,u),e??0);return this.display.decibel?[Math.max(c,l-120)-3,l+6]:[0,l*1.12||1]}clickedAt(e,t){e.select.width>2||this.clicked(e.posToVal(t.offsetX,"x"))}bands({ctx:e,bbox:t,valToPos:n}){if(this.what==="amplitude"){e.save(),e.beginPath(),e.rect(t.left,t.top,t.width,t.height),e.clip(),e.globalAlpha=gE;for(let{kind:s,stroke:r,points:o,upper:a=[]}of this.picture.overlays){if(s!=="band")continue;e.fillStyle=Xn(r,this.display.theme).colour,e.beginPath();let l=t.top+t.height;o.forEach(([c,h],u)=>{e[u?"lineTo":"moveTo"](n(c,"x",!0),h===null?l:n(h,"y",!0))});for(let[c,h]of[...a].reverse())e.lineTo(n(c,"x",!0),h===null?t.top:n(h,"y",!0));e.fill()}e.restore()}}marks(e){let{ctx:t,bbox:n}=e,s=this.picture,r=bs(this.display.theme),o=devicePixelRatio,a=h=>e.valToPos(h,"x",!0),l=h=>e.valToPos(h,"y",!0),c=(h,u,d,f)=>{h<e.scales.x.min||h>e.scales.x.max||yo(t,u,d*o,f.map(p=>p*o),[[a(h),n.top],[a(h),n.top+n.height]])};t.save(),t.beginPath(),t.rect(n.left,n.top-14*o,n.width,n.height+14*o),t.clip();for(let h of s.natural)c(h,r.mode,1,[1,3]);if(this.what==="amplitude"){let h=d=>d.map(([f,p])=>[a(f),p===null?null:l(p)]);for(let d of s.overlays)d.kind!=="band"&&this.overlay(t,d,h);for(let d of s.limits)d.isLine||this.limit(e,d);this.upwards(e,s);let u=this.peaks=Sy(e,s.curves,s.overlays);this.handles?.place(e,s.limits,this.curveFinder(e),u.taken.map(([d,f,p,_])=>[(d-n.left)/o,(f-n.top)/o,(p-n.left)/o,(_-n.top)/o])),My(t,u,d=>Xn(d,this.display.theme).colour,r)}s.cursor!==null&&c(s.cursor,r.text,1,[]),t.restore()}curveFinder(e){let{x:t,curves:n,limits:s}=this.picture,r=devicePixelRatio,{left:o,top:a}=e.bbox;if(!s.length)return()=>!1;let l=t.map(h=>e.valToPos(h,"x",!0)/r-o/r),c=n.map(h=>h.amplitude.map(u=>u===null?NaN:(e.valToPos(u,"y",!0)-a)/r));return([h,u,d,f])=>l.some((p,_)=>p>=h&&p<=d&&c.some(m=>m[_]>=u&&m[_]<=f))}limit(e,{result:t,from:n,to:s,y:r,isOfCurve:o,at:a,violated:l,binding:c}){let{ctx:h,bbox:u}=e,d=devicePixelRatio,f=bs(this.display.theme),{x:p,curves:_}=this.picture,m=c?f.violated:f.unbinding,g=y=>e.valToPos(y,"x",!0),x=e.valToPos(r,"y",!0),C=10*d,b=[Math.max(g(n),u.left),Number.isFinite(s)?Math.min(g(s),u.left+u.width):u.left+u.width];if(yo(h,l?m:f.limit,1.6*d,b[1]-b[0]>3*C?[8*d,4*d]:[],[[b[0],x],[Math.max(b[1],b[0]+C),x]]),a){let[y,M]=[g(a.x),e.valToPos(a.y,"y",!0)];h.fillStyle=l?m:f.text,h.fillRect(y-3*d,M-3*d,6*d,6*d)}if(!o)return;let A=_.find(y=>y.name===t),S=p.map(y=>y>=n&&y<=s);for(let y of A?vy(p,A.amplitude.map((M,U)=>S[U]?M:null),r):[])this.exceeding(h,m,A.stroke,y.map(([M,U])=>[g(M),e.valToPos(U,"y",!0)]))}exceeding(e,t,n,s){let{colour:r,dash:o}=Xn(n,this.display.theme),a=devicePixelRatio;yo(e,t,4.6*a,[],s),yo(e,r,Ff*a,o.map(l=>l*a),s)}overlay(e,{stroke:t,kind:n,points:s,dash:r},o){let a=devicePixelRatio,{colour:l}=Xn(t,this.display.theme),h=o(s).filter(u=>u[1]!==null);if(n==="violated"||n==="unbinding")return this.exceeding(e,bs(this.display.theme)[n],t,h);if(n==="measured")return yE(e,l,h,2*a);e.globalAlpha=n==="compared"?.7:1,yo(e,l,(n==="stable"?2.6:1.3)*a,(r??{compared:[4,3],limit:[8,4],stable:[],unstable:[3,3],jump:[1,4],band:[]}[n]).map(u=>u*a),h),n==="jump"&&h.length===2&&_E(e,l,h[0],h[1],7*a),e.globalAlpha=1}upwards(e,{x:t,curves:n}){let{ctx:s,bbox:r}=e,o=devicePixelRatio,a=r.top+Uf*o;for(let{unbounded:l,amplitude:c,stroke:h}of n)for(let u of l){let d=t.findIndex(_=>_>=u),f=[d-1,d,d+1].map(_=>c[_]??null).filter(_=>_!==null),p=e.valToPos(u,"x",!0);f.length&&yo(s,Xn(h,this.display.theme).colour,Ff*o,[2*o,3*o],[[p,e.valToPos(Math.max(...f),"y",!0)],[p,a]])}}};function _E(i,e,[t,n],[s,r],o){let a=Math.atan2(r-n,s-t);i.fillStyle=e,i.beginPath(),i.moveTo(s,r);for(let l of[-.4,.4])i.lineTo(s-o*Math.cos(a+l),r-o*Math.sin(a+l));i.fill()}function yE(i,e,t,n){i.fillStyle=e;for(let[s,r]of t)i.beginPath(),i.arc(s,r,n,0,7),i.fill()}function yo(i,e,t,n,s){i.strokeStyle=e,i.lineWidth=t,i.setLineDash(n),i.beginPath(),s.forEach(([r,o],a)=>a?i.lineTo(r,o):i.moveTo(r,o)),i.stroke(),i.setLineDash([])}var Ey=i=>(e,t,n,s)=>{let r=new Path2D,o=new Vc(r),a=e.data[0],l=e.data[t],c=null;for(let h=Math.max(n-1,0);h<=Math.min(s+1,a.length-1);h++){let u=l[h]??null;(c===null||u===null||Math.abs(u-c)>i)&&o.end(),u!==null&&o.add(e.valToPos(a[h],"x",!0),e.valToPos(u,"y",!0)),c=u}return o.end(),{stroke:r,fill:null,clip:null,band:null,gaps:null,flags:0}};var Gc=class{constructor(){this.from=[];this.curves=null}of(e){let t=e.result("curves"),n=e.revisionOf("draft")>e.revisionOf("curves")?e.result("draft"):null;return this.from.length&&t===this.from[0]&&n===this.from[1]?this.curves:(this.from=[t,n],this.curves=n&&t&&xE(n,t)?vE(n,t):t,this.curves)}},xE=(i,e)=>i.results.every(({name:t,unit:n})=>e.results.some(s=>s.name===t&&s.unit===n));function vE(i,e){let t=e.results.map(o=>i.results.findIndex(a=>a.name===o.name)),n=i.results.length,s=i.models.map(o=>({...o,pieces:o.pieces.map(a=>({...a,values:o.delays.flatMap((l,c)=>t.map(h=>h<0?[]:a.values[c*n+h]))}))})),r=e.results.map(({extrema:o,...a})=>a);return{...i,draft:!0,results:r,models:s,limits:e.limits,lines:e.lines??[],vanishing:e.vanishing??[]}}function Ty(i,e,{byPath:t}){let r=(((e?t.get(["cases",e,"limit_lines",i,"rows"].join("\0")):void 0)??t.get(["limit_lines",i,"rows"].join("\0")))?.children??[]).map(({children:[,o]})=>{let a=o&&Dn(o.raw);return a&&o?{entry:o,...a}:null});return r.length&&r.every(o=>o!==null)?r:null}var kf=(i,e,t)=>i.replaceNumbers(e.map(({entry:n,value:s,unit:r})=>[n,ys(_c(s*t),r)]));var Hc=class{constructor(e,t,n){this.app=e;this.si=t;this.changed=n;this.values=new mc;this.known=new Map;this.pulled=null;this.lines=new Map;this.judgedLevels=new Map;this.pulledLine=null;this.heights=new Map;this.began=()=>{};this.moved=(e,t)=>{let n=this.known.get(e),s=this.si(t),r=this.lines.get(e),o=this.heights.get(e);r&&o&&s>0&&(this.pulledLine={id:e,factor:r.pulled*s/o},this.changed()),n&&s>0&&this.set(n.number,n.number.value*s/n.allowed,!0)};this.dropped=e=>{let t=this.known.get(e),{pulled:n,pulledLine:s}=this,r=this.lines.get(e);if(this.pulled=this.pulledLine=null,r&&s)return kf(this.app.state,r.levels,s.factor);t&&n?Aa(this.app.state,t.number,n.value):this.app.state.dropped()};this.stepped=(e,t)=>{let n=this.known.get(e);n&&this.set(n.number,n.number.value*t,!1);let s=this.lines.get(e);s&&kf(this.app.state,s.levels,t)}}get requirements(){return this.verdict?.requirements??[]}get areBinding(){return this.verdict?.decides!==!1}present(e){let{asker:t,state:n,index:s}=this.app,r=t.isOld("verdict"),o=this.areBinding;return this.known=new Map,e.map((a,l)=>{let{requirement:c}=a,h=c.place.join("."),u=gc(c.place,n.case,n.design,s);u&&this.pulled?.place===h&&(u.value=this.pulled.value);let d=u&&this.values.allowed(c,u,!r&&!this.pulled);return u&&d!==null&&this.app.engine.isLive&&this.known.set(`${l} ${h}`,{number:u,allowed:d}),{limit:a,allowed:d??c.allowed,written:u?`${He(u.value)} ${u.unit}`.trim():c.requirement,movable:d!==null&&this.app.engine.isLive,old:r,binding:o}})}presentLines({lines:e=[]}){let{asker:t,state:n,index:s,engine:r}=this.app,o=t.isOld("curves");return this.lines=new Map,e.map((a,l)=>{let c=`line ${l} ${a.name}`,h=Ty(a.name,n.case,s),u=`${n.case} ${c}`,d=h?.[0].value??1;(!o||!this.judgedLevels.has(u))&&this.judgedLevels.set(u,d);let f=this.pulledLine?.id===c?this.pulledLine.factor:1,p=h!==null&&r.isLive;return p&&this.lines.set(c,{levels:h,pulled:f}),{id:c,line:a,factor:f*d/this.judgedLevels.get(u),movable:p,old:o||f!==1,binding:this.areBinding}})}placed(e){this.heights=new Map(e.map(t=>[t.id,this.si(t.y)]))}get verdict(){let{asker:e,state:t}=this.app;return e.result("verdict")?.cases.find(n=>n.case===t.case)}set(e,t,n){let s=_c(t);!e.path&&n&&(this.pulled={place:bE(e),value:s}),Aa(this.app.state,e,s,n),this.pulled&&this.changed()}},bE=({entry:{path:i}})=>(i[0]==="cases"?i.slice(2):i).join(".");var Bf=class extends vn{constructor(){super();this.amplitude=null;this.phase=null;this.picture=null;this.drawnCurves=new Gc;this.drawn=[];this.bandsDrawn=Ay;this.limitsDrawn="";this.notDrawn=[];this.compared=[];this.wanted="";this.hasBegun=!1;this.watcher=null;this.drawable=t=>t.results.filter(n=>n.unit===this.choice.unit&&!t.vanishing?.includes(n.name));this.reading=({amplitude:t,unbounded:n},s)=>n.includes(this.picture.x[s])?"∞":He(t[s],3);this.asTable=!1,this.spoken="",this.kept=null,this.choice={model:0,unit:"",hidden:new Set}}static{this.properties={...vn.properties,asTable:{state:!0},choice:{state:!0},kept:{state:!0},spoken:{state:!0}}}render(){let{display:t,asker:n}=this.app,s=this.drawnCurves.of(n),r=s?Mc(s):[],o=[this.wanted,this.choice.unit].find(c=>r.includes(c))??r[0]??"";s&&o!==this.choice.unit&&this.chooseUnit(s,o);let a=this.isFirstQuantityAwaited(r),l=(c,h,u)=>re`<label title=${TE[c]??""}><input type="checkbox" .checked=${h}
      @change=${d=>u(d.target.checked)}> ${c}</label>`;return re`
      <div class="bar">
        <h2 class="hidden">Characteristics</h2>${n.isOld("curves")||a?re`<span class="old">…</span>`:Re}
        ${r.length?re`<select aria-label="Quantity" @change=${c=>this.chooseQuantity(s,c.target.value)}>
          ${(this.app.engine.isLive?Cy(r):r).map(c=>re`<option value=${c} ?selected=${c===o}>${no(c)}</option>`)}</select>`:Re}
        ${s&&s.models.length>1?re`<select aria-label="Excitation" @change=${c=>{this.choice={...this.choice,model:Number(c.target.value)}}}>
          ${s.models.map((c,h)=>re`<option value=${h} ?selected=${h===this.choice.model}>${c.excitations?.join(", ")||"all excitations"}</option>`)}</select>`:Re}
        <select aria-label="Unit of frequency" @change=${c=>t.set({frequencyUnit:c.target.value})}>
          ${Object.keys(hi).map(c=>re`<option ?selected=${c===t.frequencyUnit}>${c}</option>`)}</select>
        ${l("log f",t.logarithmicFrequency,c=>t.set({logarithmicFrequency:c}))}
        ${l("log",t.logarithmicAmplitude,c=>t.set({logarithmicAmplitude:c}))}
        ${l("dB",t.decibel,c=>t.set({decibel:c}))}
        <details class="menu" @keydown=${SE}><summary title="draw others beside these curves">compare</summary><div>${l("keep these curves",this.kept!==null,c=>{this.kept=c?s:null})}${Hd(this.app).map(c=>l(Wd(c),Qg(this.app,c),h=>this.compare(c,h)))}</div></details>
        ${l("table",this.asTable,c=>{this.asTable=c})}
      </div>
      <div class="plots ${n.isOutdated("curves")?"outdated":""}" tabindex="0" role="application" aria-label="Characteristics. Left and right arrow move the cursor, page up and page down go from peak to peak, Enter makes the machine swing at the cursor." @keydown=${this.key}>
        <div class="amplitude"></div><div class="phase"></div>
        ${n.isOutdated("curves")?oo:Re}
        ${s?Re:re`<p class="missing">${yc(this.app)}</p>`}
      </div>
      <div class="readings" role="group" aria-label="Curves">${this.legend(s)}</div>
      <p class="hidden" role="status" aria-live="polite">${this.spoken}</p>
      ${this.asTable&&this.picture?this.table(this.picture):Re}`}connectedCallback(){super.connectedCallback();let{beside:t,sampler:n}=this.app;this.unsubscribe.push(t.subscribe(()=>this.requestUpdate())),n&&this.unsubscribe.push(n.subscribe(()=>{(this.bands.length||this.bandsDrawn.length)&&this.requestUpdate()}))}firstUpdated(){let t=r=>this.swing(r/hi[this.app.display.frequencyUnit]),[n,s]=[this.querySelector(".amplitude"),this.querySelector(".phase")];this.mover=new Hc(this.app,r=>H0(r,this.picture.scale,this.app.display),()=>this.requestUpdate()),this.amplitude=new Fa(n,"amplitude",this.app.display,t,this.mover),this.phase=new Fa(s,"phase",this.app.display,t);for(let r of[n,s])r.addEventListener("mousemove",o=>this.follow(o,r));this.watcher=new ResizeObserver(()=>{this.amplitude.resize(),this.phase.resize()}),this.watcher.observe(n),this.updated()}updated(){let{asker:t,display:n}=this.app,s=this.drawnCurves.of(t);if(!s||!this.amplitude)return;this.beginWithFirstLimit(s);let r=t.result("steady"),o=t0(this.app,this.kept),a=this.mover.areBinding,l=this.bandsDrawn=this.bands,c=[s,r,a,l,...o.flatMap(h=>[h.curves,h.measured?.[0],h.key]),this.choice,n.theme,n.frequencyUnit,n.logarithmicFrequency,n.decibel,n.logarithmicAmplitude];if(JSON.stringify(o.map(h=>[h.label,h.old,h.failure]))!==JSON.stringify(this.compared.map(h=>[h.label,h.old,h.failure]))&&this.requestUpdate(),this.compared=o,c.length!==this.drawn.length||c.some((h,u)=>h!==this.drawn[u]))this.drawn=c,this.picture=G0(s,this.choice,n,r,o,a,l),this.limitsDrawn=this.setLimits(s),n.drawn=this.picture.curves.map(h=>h.name),this.amplitude.show(this.picture),this.phase.show(this.picture),this.requestUpdate();else if(this.picture){let h=this.setLimits(s);h!==this.limitsDrawn&&(this.limitsDrawn=h,this.amplitude.rescale(),this.requestUpdate());let{cursor:u}=this;if(u===this.picture.cursor)return;this.picture.cursor=u,this.amplitude.redraw(),this.phase.redraw()}}disconnectedCallback(){super.disconnectedCallback(),this.watcher?.disconnect(),this.amplitude?.destroy(),this.phase?.destroy()}get bands(){let t=zd(this.app);return t?Kg(t,this.app.state.case):Ay}setLimits(t){let{display:n}=this.app,{drawn:s,not:r}=R0(t,this.choice.model,this.mover.requirements),o=this.drawable(t).map(d=>d.name);this.notDrawn=r;let a=this.picture,{scale:l}=a,{hidden:c,unit:h}=this.choice,u=L0(this.mover.presentLines(t),o,c,h,l,n,d=>Ra(d,l,n),[a.x[0]??0,a.x.at(-1)??0]);return this.mover.placed(u.handles),a.limits=[...W0(this.mover.present(s),o,c,l,n),...u.handles],a.overlays=[...u.overlays,...a.overlays.filter(d=>d.kind!=="limit")],JSON.stringify([this.picture.limits,r.map(d=>d.why)])}legend(t){if(!t||!this.picture)return Re;let n=this.picture.overlays.some(c=>c.kind==="stable"),s=n?"":this.steadyElsewhere(this.drawable(t)),{display:r}=this.app,o=this.drawable(t),a=this.indexAtCursor(),l=o[0]?.level;return re`${a===null?Re:re`<span class="cursor">${He(this.picture.x[a],4)} ${r.frequencyUnit} [${this.unit}]</span>`}${this.notDrawn.length?re`<details class="note"><summary>${this.notDrawn.length===1?"1 limit is":`${this.notDrawn.length} limits are`} not drawn</summary>
      <ul>${this.notDrawn.map(({words:c,why:h})=>re`<li>${c}: ${h}</li>`)}</ul></details>`:Re}${o.map((c,h)=>{let u=this.picture.curves.find(p=>p.name===c.name),{colour:d}=Xn(h,r.theme),f=a!==null&&u?this.reading(u,a):"";return re`<button class="curve" aria-pressed=${u!==void 0} @click=${()=>this.toggle(c.name)}>
        <svg viewBox="0 0 18 6" aria-hidden="true"><line x1="0" y1="3" x2="18" y2="3" stroke=${d} stroke-width="3" stroke-dasharray=${Xn(h,r.theme).dash.join(" ")}></line></svg>
        ${c.name}${f?re` <b>${f}</b>`:Re}</button>`})}${this.steadyAtCursor().map(({name:c,motions:h})=>re`<span class="curve steady">steady ${c}: ${h.map((u,d)=>re`${d?", ":""}<b>${u.value}</b> ${u.words}`)}</span>`)}${this.bandLegend()}${this.compared.map(c=>re`<span class="curve" title=${c.failure}><svg viewBox="0 0 26 6" aria-hidden="true">${c.measured?so`<circle cx="7" cy="3" r="2.4" fill="currentColor"></circle><circle cx="18" cy="3" r="2.4" fill="currentColor"></circle>`:so`<line x1="0" y1="3" x2="26" y2="3" stroke="currentColor" stroke-width="2" stroke-dasharray=${c.dash.join(" ")}></line>`}</svg> ${c.label}${c.failure?": not computed":""}${this.readings(c).map((h,u,d)=>re`${u?", ":": "}${h.name}${h.at} <b>${h.value}</b>${u<d.length-1?Re:` ${this.unit}`}`)}${c.old?re` <span class="old">…</span>`:Re}</span>`)}${n?re`<span class="note">thick: steady motion of the nonlinear machine, half peak-to-peak${l&&l!=="0-p"?` at the level ${l} of a sine`:""}; dashed: unstable; arrow: jump</span>`:Re}${s?re`<span class="note">${s}</span>`:Re}${this.notes()}`}bandLegend(){let t=this.picture.overlays.filter(o=>o.kind==="band"),n=t.length?zd(this.app):null,s=this.indexAtCursor();if(!n)return Re;let r=s===null?[]:t.flatMap(o=>{let a=U0(o,this.picture.x[s]);return a?[re`${o.name} <b>${He(a[0],3)} … ${He(a[1],3)}</b>`]:[]});return re`<span class="curve" title="from 5 to 95 % of the machines within the tolerances, at each frequency"><svg viewBox="0 0 18 8" aria-hidden="true"><rect width="18" height="8" fill=${Xn(t[0].stroke,this.app.display.theme).colour} fill-opacity="0.3"></rect></svg> 5 … 95 % of ${n.found.designs.toLocaleString("en-US")} designs${r.map((o,a)=>re`${a?", ":": "}${o}`)}${r.length?` ${this.unit}`:""}${n.old?re` <span class="old">…</span>`:Re}</span>`}notes(){let[t,...n]=this.app.asker.notes("curves");return re`${t?re`<span class="note">${t}</span>`:Re}${n.length?re`<details class="note"><summary>${n.length===1?"1 more note":`${n.length} more notes`}</summary>
      <ul>${n.map(s=>re`<li>${s}</li>`)}</ul></details>`:Re}`}steadyElsewhere(t){let n=this.app.asker.result("steady"),s=n?.over==="frequency"?n.results.find(r=>t.some(o=>o.name===r.name&&o.unit!==r.unit)):void 0;return s?`the steady motion is not drawn: it is computed as ${no(s.unit)}`:""}chooseUnit(t,n){let s=t.results.filter(l=>l.unit===n&&!t.vanishing?.includes(l.name)).map(l=>l.name),r=new Set([...this.app.index.byPath.values()].filter(l=>!l.children.length).flatMap(l=>l.path)),o=l=>r.has(l)?0:1,a=[...s].sort((l,c)=>o(l)-o(c));this.choice={...this.choice,unit:n,hidden:new Set(a.slice(ME))}}beginWithFirstLimit(t){let{asker:n}=this.app,s=n.result("verdict");if(this.wanted||this.hasBegun||!s)return;this.hasBegun=!0,this.requestUpdate();let r=P0(s,t);r!==null&&r!==this.choice.unit&&Cy(Mc(t)).includes(r)&&this.chooseQuantity(t,r)}isFirstQuantityAwaited(t){let{app:n}=this;return!n.engine.isLive||n.asker.failure("verdict")||n.asker.failure("curves")?!1:this.wanted?t.some(s=>EE(s,this.wanted))&&!t.includes(this.wanted):!this.hasBegun&&ei(n)&&!n.asker.hasErrors}chooseQuantity(t,n){let{display:s,asker:r,beside:o}=this.app,a=ka.findIndex(([l,c])=>l===n||c===n);if(this.wanted=n,Mc(t).includes(n))return this.chooseUnit(t,n);s.set({quantity:wE[a]}),r.again(),o.rest()}compare(t,n){let{display:s,beside:r}=this.app;s.set({compared:new Map([...s.compared,[t,n]])}),r.rest()}toggle(t){let n=new Set(this.choice.hidden);n.delete(t)||n.add(t),this.choice={...this.choice,hidden:n}}get cursor(){let{cursor:t,frequencyUnit:n}=this.app.display;return t===null?null:t*hi[n]}indexAtCursor(){let{picture:t,cursor:n}=this;if(!t||n===null||!t.x.length)return null;let s=0;return t.x.forEach((r,o)=>{Math.abs(r-n)<Math.abs(t.x[s]-n)&&(s=o)}),s}follow(t,n){let s=n.querySelector(".u-over"),r=this.picture?.x;if(!s||!r?.length)return;let{left:o,width:a}=s.getBoundingClientRect(),l=(t.clientX-o)/a,[c,h]=[r[0],r.at(-1)];if(l<0||l>1)return;let u=this.app.display.logarithmicFrequency?c*(h/c)**l:c+l*(h-c);this.app.display.set({cursor:u/hi[this.app.display.frequencyUnit]})}swing(t){if(!this.app.engine.isLive)return this.app.display.set({cursor:t});this.app.display.set({shown:{kind:"frequency",omega:t},cursor:t}),this.app.asker.again()}key(t){let{display:n}=this.app,s=this.picture?.x,r=hi[n.frequencyUnit];if(!s?.length||t.ctrlKey||t.metaKey||t.altKey)return;let o=this.indexAtCursor()??0,a=[...new Set(this.picture.curves.flatMap(p=>[...p.peaks.map(_=>_.x),...p.unbounded]))].sort((p,_)=>p-_),l=t.shiftKey?.05:.004,c=this.picture.cursor??s[0],[h,u]=[s[0],s.at(-1)],d=p=>{let _=n.logarithmicFrequency?c*(u/h)**(p*l):c+p*l*(u-h);return Math.min(Math.max(_,h),u)},f={ArrowRight:d(1),ArrowLeft:d(-1),Home:h,End:u,PageDown:a.find(p=>p>c*(1+1e-9)),PageUp:a.findLast(p=>p<c*(1-1e-9))};if(t.key==="Enter")this.swing(s[o]/r);else if(t.key in f){let p=f[t.key];p!==void 0&&n.set({cursor:p/r}),this.updateComplete.then(()=>this.speak())}else return;t.preventDefault()}speak(){let t=this.indexAtCursor(),{picture:n}=this;if(t===null||!n)return;let s=this.steadyAtCursor().map(({name:o,motions:a})=>[`steady ${o} ${a.map(l=>`${l.value} ${this.unit} ${l.words}`).join(", ")}`]),r=[n.curves.map(o=>`${o.name} ${this.reading(o,t)} ${this.unit}`),...this.compared.map(o=>this.readings(o).map((a,l)=>`${l?"":`${o.label}: `}${a.name}${a.at} ${a.value} ${this.unit}`)),...s];this.spoken=`${He(n.x[t],4)} ${this.app.display.frequencyUnit}: ${r.filter(o=>o.length).map(o=>o.join(", ")).join("; ")}`}get unit(){return this.app.display.decibel?"dB":this.picture.scale.unit}readings({key:t}){let{picture:n}=this,s=this.indexAtCursor();if(s===null||!n)return[];let r=a=>`${He(a,4)} ${this.app.display.frequencyUnit}`,o=r(n.x[s]);return n.overlays.filter(a=>a.of===t).flatMap(a=>{let l=Sc(a,n.x[s]);return l?[{name:a.name,at:r(l.x)===o?"":` at ${r(l.x)}`,value:He(l.y,3)}]:[]})}steadyAtCursor(){let{picture:t}=this,n=this.indexAtCursor();if(n===null||!t)return[];let s=t.x[n],r=o=>`${He(o,4)} ${this.app.display.frequencyUnit}`;return t.steady.map(o=>({name:o.name,motions:z0(o,s).map(a=>({value:He(a.y,3),words:`${Ca(a)}${r(a.x)===r(s)?"":` at ${r(a.x)}`}`}))})).filter(o=>o.motions.length)}steadyTable({steady:t}){let n=t[0]?.branches??[];return n.length?re`<table><caption>Steady motions, half peak-to-peak [${this.unit}]</caption><thead><tr><th scope="col">${this.app.display.frequencyUnit}</th>${t.map(s=>re`<th scope="col">${s.name}</th>`)}<th scope="col">stability</th></tr></thead>
      <tbody>${n.flatMap((s,r)=>s.map((o,a)=>re`<tr><th scope="row">${He(o.x,4)}</th>${t.map(l=>re`<td>${He(l.branches[r][a].y,3)}</td>`)}<td>${Ca(o)}</td></tr>`))}</tbody></table>`:Re}table(t){let{x:n,curves:s}=t,r=n.map((a,l)=>l).filter(a=>a%Math.ceil(n.length/60)===0),o=this.unit;return re`<div class="scroll table" tabindex="0"><table><caption>Amplitudes [${o}]</caption><thead><tr><th scope="col">${this.app.display.frequencyUnit}</th>${s.map(a=>re`<th scope="col">${a.name}</th>`)}</tr></thead>
      <tbody>${r.map(a=>re`<tr><th scope="row">${He(n[a],4)}</th>${s.map(l=>re`<td>${this.reading(l,a)}</td>`)}</tr>`)}</tbody></table>${this.steadyTable(t)}</div>`}};function SE(i){let e=i.currentTarget;i.key!=="Escape"||!e.open||(e.open=!1,e.querySelector("summary").focus(),i.stopPropagation())}var ME=6,Ay=[],ka=[["m","rad"],["m/s","rad/s"],["m/s²","rad/s²"]],wE=["displacement","velocity","acceleration"],EE=(i,e)=>[0,1].some(t=>[i,e].every(n=>ka.some(s=>s[t]===n))),Cy=i=>[...[0,1].flatMap(e=>i.some(t=>ka.some(n=>n[e]===t))?ka.map(t=>t[e]):[]),...i.filter(e=>!ka.some(t=>t.includes(e)))],TE={"log f":"logarithmic frequency",log:"logarithmic amplitude",dB:"decibels of the SI unit","keep these curves":"dashed, to compare with changed ones",table:"the values as a table"};ue.define("curve-chart",Bf);var cr={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},hr={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},dx=0,bp=1,fx=2;var Tl=1,px=2,Jo=3,ur=0,Qn=1,Pi=2,Os=0,dr=1,Sp=2,Mp=3,wp=4,mx=5;var Br=100,gx=101,_x=102,yx=103,xx=104,vx=200,bx=201,Sx=202,Mx=203,Ep=204,Tp=205,wx=206,Ex=207,Tx=208,Ax=209,Cx=210,Rx=211,Px=212,Ix=213,Lx=214,bh=0,Sh=1,Mh=2,ko=3,wh=4,Eh=5,Th=6,Ah=7,Qo=0,Dx=1,Nx=2,hs=0,Ap=1,Cp=2,Rp=3,Pp=4,Ip=5,Lp=6,Dp=7;var Np=300,zr=301,ea=302,lu=303,cu=304,Ch=1e3,as=1001,Rh=1002,On=1003,Ox=1004;var Al=1005;var Kn=1006,hu=1007;var Us=1008;var ii=1009,Op=1010,Up=1011,ta=1012,uu=1013,$i=1014,qi=1015,Xi=1016,du=1017,fu=1018,Vr=1020,Fp=35902,kp=35899,Bp=1021,zp=1022,Yi=1023,Ps=1026,Fs=1027,Vp=1028,pu=1029,fr=1030,mu=1031;var gu=1033,Cl=33776,Rl=33777,Pl=33778,Il=33779,_u=35840,yu=35841,xu=35842,vu=35843,bu=36196,Su=37492,Mu=37496,wu=37488,Eu=37489,Ll=37490,Tu=37491,Au=37808,Cu=37809,Ru=37810,Pu=37811,Iu=37812,Lu=37813,Du=37814,Nu=37815,Ou=37816,Uu=37817,Fu=37818,ku=37819,Bu=37820,zu=37821,Vu=36492,Gu=36494,Hu=36495,Wu=36283,$u=36284,Dl=36285,qu=36286;var Ka=2300,Ph=2301,xh=2302,fp=2303,pp=2400,mp=2401,gp=2402;var Ux=3200;var Xu=0,Fx=1,ks="",gi="srgb",Ja="srgb-linear",Qa="linear",Dt="srgb";var vh=7680;var kx=519,Bx=512,zx=513,Vx=514,Gp=515,Gx=516,Hx=517,Hp=518,Wp=519,$p=35044;var qp="300 es",Ai=2e3,Bo=2001;function AE(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}function CE(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function el(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function Wx(){let i=el("canvas");return i.style.display="block",i}var Ry={},zo=null;function tl(...i){let e="THREE."+i.shift();zo?zo("log",e,...i):console.log(e,...i)}function $x(i){let e=i[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=i[1];t&&t.isStackTrace?i[0]+=" "+t.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function Ze(...i){i=$x(i);let e="THREE."+i.shift();if(zo)zo("warn",e,...i);else{let t=i[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...i)}}function Qe(...i){i=$x(i);let e="THREE."+i.shift();if(zo)zo("error",e,...i);else{let t=i[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...i)}}function Xa(...i){let e=i.join(" ");e in Ry||(Ry[e]=!0,Ze(...i))}function qx(i,e,t){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:n()}}setTimeout(r,t)})}var Xx={[bh]:bh,[Mh]:Th,[wh]:wh,[ko]:Eh,[Sh]:Sh,[Th]:Mh,[Ah]:Ah,[Eh]:ko},Gi=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n===void 0?!1:n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let n=this._listeners;if(n===void 0)return;let s=n[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let n=t[e.type];if(n!==void 0){e.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},Bn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Py=1234567,Uo=Math.PI/180,Vo=180/Math.PI;function pr(){let i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(Bn[i&255]+Bn[i>>8&255]+Bn[i>>16&255]+Bn[i>>24&255]+"-"+Bn[e&255]+Bn[e>>8&255]+"-"+Bn[e>>16&15|64]+Bn[e>>24&255]+"-"+Bn[t&63|128]+Bn[t>>8&255]+"-"+Bn[t>>16&255]+Bn[t>>24&255]+Bn[n&255]+Bn[n>>8&255]+Bn[n>>16&255]+Bn[n>>24&255]).toLowerCase()}function ht(i,e,t){return Math.max(e,Math.min(t,i))}function Xp(i,e){return(i%e+e)%e}function RE(i,e,t,n,s){return n+(i-e)*(s-n)/(t-e)}function PE(i,e,t){return i!==e?(t-i)/(e-i):0}function Ya(i,e,t){return(1-t)*i+t*e}function IE(i,e,t,n){return Ya(i,e,1-Math.exp(-t*n))}function LE(i,e=1){return e-Math.abs(Xp(i,e*2)-e)}function DE(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*(3-2*i))}function NE(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*i*(i*(i*6-15)+10))}function OE(i,e){return i+Math.floor(Math.random()*(e-i+1))}function UE(i,e){return i+Math.random()*(e-i)}function FE(i){return i*(.5-Math.random())}function kE(i){i!==void 0&&(Py=i);let e=Py+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function BE(i){return i*Uo}function zE(i){return i*Vo}function VE(i){return i>0&&Number.isInteger(i)&&2**Math.round(Math.log2(i))===i}function GE(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function Yp(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function HE(i,e,t,n,s){let r=Math.cos,o=Math.sin,a=r(t/2),l=o(t/2),c=r((e+n)/2),h=o((e+n)/2),u=r((e-n)/2),d=o((e-n)/2),f=r((n-e)/2),p=o((n-e)/2);switch(s){case"XYX":i.set(a*h,l*u,l*d,a*c);break;case"YZY":i.set(l*d,a*h,l*u,a*c);break;case"ZXZ":i.set(l*u,l*d,a*h,a*c);break;case"XZX":i.set(a*h,l*p,l*f,a*c);break;case"YXY":i.set(l*f,a*h,l*p,a*c);break;case"ZYZ":i.set(l*p,l*f,a*h,a*c);break;default:Ze("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Yu(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function jp(i,e){if(e.constructor===Float32Array)return i;let t=Yu(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/t,-1)}function Zp(i,e){if(e.constructor===Float32Array)return i;let t=Yu(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*t)}var Kp={DEG2RAD:Uo,RAD2DEG:Vo,generateUUID:pr,clamp:ht,euclideanModulo:Xp,mapLinear:RE,inverseLerp:PE,lerp:Ya,damp:IE,pingpong:LE,smoothstep:DE,smootherstep:NE,randInt:OE,randFloat:UE,randFloatSpread:FE,seededRandom:kE,degToRad:BE,radToDeg:zE,isPowerOfTwo:VE,ceilPowerOfTwo:GE,floorPowerOfTwo:Yp,setQuaternionFromProperEuler:HE,normalize:Zp,denormalize:jp},Se=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,n=this.y,s=e.elements;return this.x=s[0]*t+s[3]*n+s[6],this.y=s[1]*t+s[4]*n+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=ht(this.x,e.x,t.x),this.y=ht(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=ht(this.x,e,t),this.y=ht(this.y,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ht(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(ht(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let n=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*n-o*s+e.x,this.y=r*s+o*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Mn=class{constructor(e=0,t=0,n=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=s}static slerpFlat(e,t,n,s,r,o,a){let l=n[s+0],c=n[s+1],h=n[s+2],u=n[s+3],d=r[o+0],f=r[o+1],p=r[o+2],_=r[o+3];if(u!==_||l!==d||c!==f||h!==p){let m=l*d+c*f+h*p+u*_;m<0&&(d=-d,f=-f,p=-p,_=-_,m=-m);let g=1-a;if(m<.9995){let x=Math.acos(m),C=Math.sin(x);g=Math.sin(g*x)/C,a=Math.sin(a*x)/C,l=l*g+d*a,c=c*g+f*a,h=h*g+p*a,u=u*g+_*a}else{l=l*g+d*a,c=c*g+f*a,h=h*g+p*a,u=u*g+_*a;let x=1/Math.sqrt(l*l+c*c+h*h+u*u);l*=x,c*=x,h*=x,u*=x}}e[t]=l,e[t+1]=c,e[t+2]=h,e[t+3]=u}static multiplyQuaternionsFlat(e,t,n,s,r,o){let a=n[s],l=n[s+1],c=n[s+2],h=n[s+3],u=r[o],d=r[o+1],f=r[o+2],p=r[o+3];return e[t]=a*p+h*u+l*f-c*d,e[t+1]=l*p+h*d+c*u-a*f,e[t+2]=c*p+h*f+a*d-l*u,e[t+3]=h*p-a*u-l*d-c*f,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,s){return this._x=e,this._y=t,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let n=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(n/2),h=a(s/2),u=a(r/2),d=l(n/2),f=l(s/2),p=l(r/2);switch(o){case"XYZ":this._x=d*h*u+c*f*p,this._y=c*f*u-d*h*p,this._z=c*h*p+d*f*u,this._w=c*h*u-d*f*p;break;case"YXZ":this._x=d*h*u+c*f*p,this._y=c*f*u-d*h*p,this._z=c*h*p-d*f*u,this._w=c*h*u+d*f*p;break;case"ZXY":this._x=d*h*u-c*f*p,this._y=c*f*u+d*h*p,this._z=c*h*p+d*f*u,this._w=c*h*u-d*f*p;break;case"ZYX":this._x=d*h*u-c*f*p,this._y=c*f*u+d*h*p,this._z=c*h*p-d*f*u,this._w=c*h*u+d*f*p;break;case"YZX":this._x=d*h*u+c*f*p,this._y=c*f*u+d*h*p,this._z=c*h*p-d*f*u,this._w=c*h*u-d*f*p;break;case"XZY":this._x=d*h*u-c*f*p,this._y=c*f*u-d*h*p,this._z=c*h*p+d*f*u,this._w=c*h*u+d*f*p;break;default:Ze("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let n=t/2,s=Math.sin(n);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,n=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],h=t[6],u=t[10],d=n+a+u;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(h-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(n>a&&n>u){let f=2*Math.sqrt(1+n-a-u);this._w=(h-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>u){let f=2*Math.sqrt(1+a-n-u);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+h)/f}else{let f=2*Math.sqrt(1+u-n-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+h)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<1e-8?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(ht(this.dot(e),-1,1)))}rotateTowards(e,t){let n=this.angleTo(e);if(n===0)return this;let s=Math.min(1,t/n);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,h=t._w;return this._x=n*h+o*a+s*c-r*l,this._y=s*h+o*l+r*a-n*c,this._z=r*h+o*c+n*l-s*a,this._w=o*h-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(n=-n,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),h=Math.sin(c);l=Math.sin(l*c)/h,t=Math.sin(t*c)/h,this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},I=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,n=0){this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(Iy.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(Iy.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*n+r[6]*s,this.y=r[1]*t+r[4]*n+r[7]*s,this.z=r[2]*t+r[5]*n+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,n=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*n),h=2*(a*t-r*s),u=2*(r*n-o*t);return this.x=t+l*c+o*u-a*h,this.y=n+l*h+a*c-r*u,this.z=s+l*u+r*h-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*n+r[8]*s,this.y=r[1]*t+r[5]*n+r[9]*s,this.z=r[2]*t+r[6]*n+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=ht(this.x,e.x,t.x),this.y=ht(this.y,e.y,t.y),this.z=ht(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=ht(this.x,e,t),this.y=ht(this.y,e,t),this.z=ht(this.z,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ht(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let n=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return zf.copy(this).projectOnVector(e),this.sub(zf)}reflect(e){return this.sub(zf.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(ht(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y,s=this.z-e.z;return t*t+n*n+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){let s=Math.sin(t)*e;return this.x=s*Math.sin(n),this.y=Math.cos(t)*e,this.z=s*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},zf=new I,Iy=new Mn,it=class{static{this.prototype.isMatrix3=!0}constructor(e,t,n,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c)}set(e,t,n,s,r,o,a,l,c){let h=this.elements;return h[0]=e,h[1]=s,h[2]=a,h[3]=t,h[4]=r,h[5]=l,h[6]=n,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],h=n[4],u=n[7],d=n[2],f=n[5],p=n[8],_=s[0],m=s[3],g=s[6],x=s[1],C=s[4],b=s[7],A=s[2],S=s[5],y=s[8];return r[0]=o*_+a*x+l*A,r[3]=o*m+a*C+l*S,r[6]=o*g+a*b+l*y,r[1]=c*_+h*x+u*A,r[4]=c*m+h*C+u*S,r[7]=c*g+h*b+u*y,r[2]=d*_+f*x+p*A,r[5]=d*m+f*C+p*S,r[8]=d*g+f*b+p*y,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8];return t*o*h-t*a*c-n*r*h+n*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],u=h*o-a*c,d=a*l-h*r,f=c*r-o*l,p=t*u+n*d+s*f;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let _=1/p;return e[0]=u*_,e[1]=(s*c-h*n)*_,e[2]=(a*n-s*o)*_,e[3]=d*_,e[4]=(h*t-s*l)*_,e[5]=(s*r-a*t)*_,e[6]=f*_,e[7]=(n*l-c*t)*_,e[8]=(o*t-n*r)*_,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return Xa("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Vf.makeScale(e,t)),this}rotate(e){return Xa("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Vf.makeRotation(-e)),this}translate(e,t){return Xa("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Vf.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<9;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}},Vf=new it,Ly=new it().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Dy=new it().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function WE(){let i={enabled:!0,workingColorSpace:Ja,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Dt&&(s.r=Rs(s.r),s.g=Rs(s.g),s.b=Rs(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Dt&&(s.r=Fo(s.r),s.g=Fo(s.g),s.b=Fo(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===ks?Qa:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[Ja]:{primaries:e,whitePoint:n,transfer:Qa,toXYZ:Ly,fromXYZ:Dy,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:gi},outputColorSpaceConfig:{drawingBufferColorSpace:gi}},[gi]:{primaries:e,whitePoint:n,transfer:Dt,toXYZ:Ly,fromXYZ:Dy,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:gi}}}),i}var St=WE();function Rs(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function Fo(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var xo,Ih=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let n;if(e instanceof HTMLCanvasElement)n=e;else{xo===void 0&&(xo=el("canvas")),xo.width=e.width,xo.height=e.height;let s=xo.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),n=xo}return n.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=el("canvas");t.width=e.width,t.height=e.height;let n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);let s=n.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Rs(r[o]/255)*255;return n.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let n=0;n<t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(Rs(t[n]/255)*255):t[n]=Rs(t[n]);return{data:t,width:e.width,height:e.height}}else return Ze("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},$E=0,Go=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:$E++}),this.uuid=pr(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Gf(s[o].image)):r.push(Gf(s[o]))}else r=Gf(s);n.url=r}return t||(e.images[this.uuid]=n),n}};function Gf(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?Ih.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(Ze("Texture: Unable to serialize Texture."),{})}var qE=0,Hf=new I,Jn=class i extends Gi{constructor(e=i.DEFAULT_IMAGE,t=i.DEFAULT_MAPPING,n=as,s=as,r=Kn,o=Us,a=Yi,l=ii,c=i.DEFAULT_ANISOTROPY,h=ks){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:qE++}),this.uuid=pr(),this.name="",this.source=new Go(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Se(0,0),this.repeat=new Se(1,1),this.center=new Se(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new it,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Hf).x}get height(){return this.source.getSize(Hf).y}get depth(){return this.source.getSize(Hf).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let n=e[t];if(n===void 0){Ze(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ze(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==Np)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case Ch:e.x=e.x-Math.floor(e.x);break;case as:e.x=e.x<0?0:1;break;case Rh:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case Ch:e.y=e.y-Math.floor(e.y);break;case as:e.y=e.y<0?0:1;break;case Rh:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};Jn.DEFAULT_IMAGE=null;Jn.DEFAULT_MAPPING=Np;Jn.DEFAULT_ANISOTROPY=1;var Jt=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,n=0,s=1){this.x=e,this.y=t,this.z=n,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,s){return this.x=e,this.y=t,this.z=n,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*n+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,s,r,l=e.elements,c=l[0],h=l[4],u=l[8],d=l[1],f=l[5],p=l[9],_=l[2],m=l[6],g=l[10];if(Math.abs(h-d)<.01&&Math.abs(u-_)<.01&&Math.abs(p-m)<.01){if(Math.abs(h+d)<.1&&Math.abs(u+_)<.1&&Math.abs(p+m)<.1&&Math.abs(c+f+g-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let C=(c+1)/2,b=(f+1)/2,A=(g+1)/2,S=(h+d)/4,y=(u+_)/4,M=(p+m)/4;return C>b&&C>A?C<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(C),s=S/n,r=y/n):b>A?b<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(b),n=S/s,r=M/s):A<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(A),n=y/r,s=M/r),this.set(n,s,r,t),this}let x=Math.sqrt((m-p)*(m-p)+(u-_)*(u-_)+(d-h)*(d-h));return Math.abs(x)<.001&&(x=1),this.x=(m-p)/x,this.y=(u-_)/x,this.z=(d-h)/x,this.w=Math.acos((c+f+g-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=ht(this.x,e.x,t.x),this.y=ht(this.y,e.y,t.y),this.z=ht(this.z,e.z,t.z),this.w=ht(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=ht(this.x,e,t),this.y=ht(this.y,e,t),this.z=ht(this.z,e,t),this.w=ht(this.w,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ht(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Lh=class extends Gi{constructor(e=1,t=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Kn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=n.depth,this.scissor=new Jt(0,0,e,t),this.scissorTest=!1,this.viewport=new Jt(0,0,e,t),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new Jn({width:e,height:t,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:Kn,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,n=e.textures.length;t<n;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new Go(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},xi=class extends Lh{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}},nl=class extends Jn{constructor(e=null,t=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=On,this.minFilter=On,this.wrapR=as,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var Dh=class extends Jn{constructor(e=null,t=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=On,this.minFilter=On,this.wrapR=as,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var yt=class i{static{this.prototype.isMatrix4=!0}constructor(e,t,n,s,r,o,a,l,c,h,u,d,f,p,_,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c,h,u,d,f,p,_,m)}set(e,t,n,s,r,o,a,l,c,h,u,d,f,p,_,m){let g=this.elements;return g[0]=e,g[4]=t,g[8]=n,g[12]=s,g[1]=r,g[5]=o,g[9]=a,g[13]=l,g[2]=c,g[6]=h,g[10]=u,g[14]=d,g[3]=f,g[7]=p,g[11]=_,g[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){let t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),n.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,n=e.elements,s=1/vo.setFromMatrixColumn(e,0).length(),r=1/vo.setFromMatrixColumn(e,1).length(),o=1/vo.setFromMatrixColumn(e,2).length();return t[0]=n[0]*s,t[1]=n[1]*s,t[2]=n[2]*s,t[3]=0,t[4]=n[4]*r,t[5]=n[5]*r,t[6]=n[6]*r,t[7]=0,t[8]=n[8]*o,t[9]=n[9]*o,t[10]=n[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,n=e.x,s=e.y,r=e.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),u=Math.sin(r);if(e.order==="XYZ"){let d=o*h,f=o*u,p=a*h,_=a*u;t[0]=l*h,t[4]=-l*u,t[8]=c,t[1]=f+p*c,t[5]=d-_*c,t[9]=-a*l,t[2]=_-d*c,t[6]=p+f*c,t[10]=o*l}else if(e.order==="YXZ"){let d=l*h,f=l*u,p=c*h,_=c*u;t[0]=d+_*a,t[4]=p*a-f,t[8]=o*c,t[1]=o*u,t[5]=o*h,t[9]=-a,t[2]=f*a-p,t[6]=_+d*a,t[10]=o*l}else if(e.order==="ZXY"){let d=l*h,f=l*u,p=c*h,_=c*u;t[0]=d-_*a,t[4]=-o*u,t[8]=p+f*a,t[1]=f+p*a,t[5]=o*h,t[9]=_-d*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let d=o*h,f=o*u,p=a*h,_=a*u;t[0]=l*h,t[4]=p*c-f,t[8]=d*c+_,t[1]=l*u,t[5]=_*c+d,t[9]=f*c-p,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let d=o*l,f=o*c,p=a*l,_=a*c;t[0]=l*h,t[4]=_-d*u,t[8]=p*u+f,t[1]=u,t[5]=o*h,t[9]=-a*h,t[2]=-c*h,t[6]=f*u+p,t[10]=d-_*u}else if(e.order==="XZY"){let d=o*l,f=o*c,p=a*l,_=a*c;t[0]=l*h,t[4]=-u,t[8]=c*h,t[1]=d*u+_,t[5]=o*h,t[9]=f*u-p,t[2]=p*u-f,t[6]=a*h,t[10]=_*u+d}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(XE,e,YE)}lookAt(e,t,n){let s=this.elements;return pi.subVectors(e,t),pi.lengthSq()===0&&(pi.z=1),pi.normalize(),Js.crossVectors(n,pi),Js.lengthSq()===0&&(Math.abs(n.z)===1?pi.x+=1e-4:pi.z+=1e-4,pi.normalize(),Js.crossVectors(n,pi)),Js.normalize(),Wc.crossVectors(pi,Js),s[0]=Js.x,s[4]=Wc.x,s[8]=pi.x,s[1]=Js.y,s[5]=Wc.y,s[9]=pi.y,s[2]=Js.z,s[6]=Wc.z,s[10]=pi.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],h=n[1],u=n[5],d=n[9],f=n[13],p=n[2],_=n[6],m=n[10],g=n[14],x=n[3],C=n[7],b=n[11],A=n[15],S=s[0],y=s[4],M=s[8],U=s[12],N=s[1],L=s[5],V=s[9],W=s[13],O=s[2],G=s[6],j=s[10],z=s[14],ce=s[3],Z=s[7],J=s[11],ie=s[15];return r[0]=o*S+a*N+l*O+c*ce,r[4]=o*y+a*L+l*G+c*Z,r[8]=o*M+a*V+l*j+c*J,r[12]=o*U+a*W+l*z+c*ie,r[1]=h*S+u*N+d*O+f*ce,r[5]=h*y+u*L+d*G+f*Z,r[9]=h*M+u*V+d*j+f*J,r[13]=h*U+u*W+d*z+f*ie,r[2]=p*S+_*N+m*O+g*ce,r[6]=p*y+_*L+m*G+g*Z,r[10]=p*M+_*V+m*j+g*J,r[14]=p*U+_*W+m*z+g*ie,r[3]=x*S+C*N+b*O+A*ce,r[7]=x*y+C*L+b*G+A*Z,r[11]=x*M+C*V+b*j+A*J,r[15]=x*U+C*W+b*z+A*ie,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],h=e[2],u=e[6],d=e[10],f=e[14],p=e[3],_=e[7],m=e[11],g=e[15],x=l*f-c*d,C=a*f-c*u,b=a*d-l*u,A=o*f-c*h,S=o*d-l*h,y=o*u-a*h;return t*(_*x-m*C+g*b)-n*(p*x-m*A+g*S)+s*(p*C-_*A+g*y)-r*(p*b-_*S+m*y)}determinantAffine(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],h=e[10];return t*(o*h-a*c)-n*(r*h-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=n),this}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],u=e[9],d=e[10],f=e[11],p=e[12],_=e[13],m=e[14],g=e[15],x=t*a-n*o,C=t*l-s*o,b=t*c-r*o,A=n*l-s*a,S=n*c-r*a,y=s*c-r*l,M=h*_-u*p,U=h*m-d*p,N=h*g-f*p,L=u*m-d*_,V=u*g-f*_,W=d*g-f*m,O=x*W-C*V+b*L+A*N-S*U+y*M;if(O===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let G=1/O;return e[0]=(a*W-l*V+c*L)*G,e[1]=(s*V-n*W-r*L)*G,e[2]=(_*y-m*S+g*A)*G,e[3]=(d*S-u*y-f*A)*G,e[4]=(l*N-o*W-c*U)*G,e[5]=(t*W-s*N+r*U)*G,e[6]=(m*b-p*y-g*C)*G,e[7]=(h*y-d*b+f*C)*G,e[8]=(o*V-a*N+c*M)*G,e[9]=(n*N-t*V-r*M)*G,e[10]=(p*S-_*b+g*x)*G,e[11]=(u*b-h*S-f*x)*G,e[12]=(a*U-o*L-l*M)*G,e[13]=(t*L-n*U+s*M)*G,e[14]=(_*C-p*A-m*x)*G,e[15]=(h*A-u*C+d*x)*G,this}scale(e){let t=this.elements,n=e.x,s=e.y,r=e.z;return t[0]*=n,t[4]*=s,t[8]*=r,t[1]*=n,t[5]*=s,t[9]*=r,t[2]*=n,t[6]*=s,t[10]*=r,t[3]*=n,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,s))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let n=Math.cos(t),s=Math.sin(t),r=1-n,o=e.x,a=e.y,l=e.z,c=r*o,h=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+n,h*l-s*o,0,c*l-s*a,h*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,s,r,o){return this.set(1,n,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,n){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,h=o+o,u=a+a,d=r*c,f=r*h,p=r*u,_=o*h,m=o*u,g=a*u,x=l*c,C=l*h,b=l*u,A=n.x,S=n.y,y=n.z;return s[0]=(1-(_+g))*A,s[1]=(f+b)*A,s[2]=(p-C)*A,s[3]=0,s[4]=(f-b)*S,s[5]=(1-(d+g))*S,s[6]=(m+x)*S,s[7]=0,s[8]=(p+C)*y,s[9]=(m-x)*y,s[10]=(1-(d+_))*y,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,n){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),t.identity(),this;let o=vo.set(s[0],s[1],s[2]).length(),a=vo.set(s[4],s[5],s[6]).length(),l=vo.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Bi.copy(this);let c=1/o,h=1/a,u=1/l;return Bi.elements[0]*=c,Bi.elements[1]*=c,Bi.elements[2]*=c,Bi.elements[4]*=h,Bi.elements[5]*=h,Bi.elements[6]*=h,Bi.elements[8]*=u,Bi.elements[9]*=u,Bi.elements[10]*=u,t.setFromRotationMatrix(Bi),n.x=o,n.y=a,n.z=l,this}makePerspective(e,t,n,s,r,o,a=Ai,l=!1){let c=this.elements,h=2*r/(t-e),u=2*r/(n-s),d=(t+e)/(t-e),f=(n+s)/(n-s),p,_;if(l)p=r/(o-r),_=o*r/(o-r);else if(a===Ai)p=-(o+r)/(o-r),_=-2*o*r/(o-r);else if(a===Bo)p=-o/(o-r),_=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=u,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=p,c[14]=_,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,n,s,r,o,a=Ai,l=!1){let c=this.elements,h=2/(t-e),u=2/(n-s),d=-(t+e)/(t-e),f=-(n+s)/(n-s),p,_;if(l)p=1/(o-r),_=o/(o-r);else if(a===Ai)p=-2/(o-r),_=-(o+r)/(o-r);else if(a===Bo)p=-1/(o-r),_=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=u,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=p,c[14]=_,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<16;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}},vo=new I,Bi=new yt,XE=new I(0,0,0),YE=new I(1,1,1),Js=new I,Wc=new I,pi=new I,Ny=new yt,Oy=new Mn,Is=class i{constructor(e=0,t=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=n,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,s=this._order){return this._x=e,this._y=t,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],h=s[9],u=s[2],d=s[6],f=s[10];switch(t){case"XYZ":this._y=Math.asin(ht(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-ht(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(ht(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-u,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-ht(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(ht(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-ht(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,f),this._y=0);break;default:Ze("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return Ny.makeRotationFromQuaternion(e),this.setFromRotationMatrix(Ny,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return Oy.setFromEuler(this),this.setFromQuaternion(Oy,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Is.DEFAULT_ORDER="XYZ";var Ho=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},jE=0,Uy=new I,bo=new Mn,ws=new yt,$c=new I,Ba=new I,ZE=new I,KE=new Mn,Fy=new I(1,0,0),ky=new I(0,1,0),By=new I(0,0,1),zy={type:"added"},JE={type:"removed"},So={type:"childadded",child:null},Wf={type:"childremoved",child:null},wn=class i extends Gi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:jE++}),this.uuid=pr(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let e=new I,t=new Is,n=new Mn,s=new I(1,1,1);function r(){n.setFromEuler(t,!1)}function o(){t.setFromQuaternion(n,void 0,!1)}t._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new yt},normalMatrix:{value:new it}}),this.matrix=new yt,this.matrixWorld=new yt,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Ho,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return bo.setFromAxisAngle(e,t),this.quaternion.multiply(bo),this}rotateOnWorldAxis(e,t){return bo.setFromAxisAngle(e,t),this.quaternion.premultiply(bo),this}rotateX(e){return this.rotateOnAxis(Fy,e)}rotateY(e){return this.rotateOnAxis(ky,e)}rotateZ(e){return this.rotateOnAxis(By,e)}translateOnAxis(e,t){return Uy.copy(e).applyQuaternion(this.quaternion),this.position.add(Uy.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(Fy,e)}translateY(e){return this.translateOnAxis(ky,e)}translateZ(e){return this.translateOnAxis(By,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(ws.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?$c.copy(e):$c.set(e,t,n);let s=this.parent;this.updateWorldMatrix(!0,!1),Ba.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?ws.lookAt(Ba,$c,this.up):ws.lookAt($c,Ba,this.up),this.quaternion.setFromRotationMatrix(ws),s&&(ws.extractRotation(s.matrixWorld),bo.setFromRotationMatrix(ws),this.quaternion.premultiply(bo.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(Qe("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(zy),So.child=e,this.dispatchEvent(So),So.child=null):Qe("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(JE),Wf.child=e,this.dispatchEvent(Wf),Wf.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),ws.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),ws.multiply(e.parent.matrixWorld)),e.applyMatrix4(ws),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(zy),So.child=e,this.dispatchEvent(So),So.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ba,e,ZE),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ba,KE,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,n=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*n-r[8]*s,r[13]+=n-r[1]*t-r[5]*n-r[9]*s,r[14]+=s-r[2]*t-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t,n=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,n)}}toJSON(e){let t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let u=l[c];r(e.shapes,u)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),h=o(e.images),u=o(e.shapes),d=o(e.skeletons),f=o(e.animations),p=o(e.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),h.length>0&&(n.images=h),u.length>0&&(n.shapes=u),d.length>0&&(n.skeletons=d),f.length>0&&(n.animations=f),p.length>0&&(n.nodes=p)}return n.object=s,n;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){let s=e.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};wn.DEFAULT_UP=new I(0,1,0);wn.DEFAULT_MATRIX_AUTO_UPDATE=!0;wn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Pt=class extends wn{constructor(){super(),this.isGroup=!0,this.type="Group"}},QE={type:"move"},Wo=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Pt,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Pt,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new I,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new I),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Pt,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new I,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new I,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let _ of e.hand.values()){let m=t.getJointPose(_,n),g=this._getHandJoint(c,_);m!==null&&(g.matrix.fromArray(m.transform.matrix),g.matrix.decompose(g.position,g.quaternion,g.scale),g.matrixWorldNeedsUpdate=!0,g.jointRadius=m.radius),g.visible=m!==null}let h=c.joints["index-finger-tip"],u=c.joints["thumb-tip"],d=h.position.distanceTo(u.position),f=.02,p=.005;c.inputState.pinching&&d>f+p?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&d<=f-p&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(QE)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let n=new Pt;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}},Yx={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Qs={h:0,s:0,l:0},qc={h:0,s:0,l:0};function $f(i,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}var ot=class{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=gi){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,St.colorSpaceToWorking(this,t),this}setRGB(e,t,n,s=St.workingColorSpace){return this.r=e,this.g=t,this.b=n,St.colorSpaceToWorking(this,s),this}setHSL(e,t,n,s=St.workingColorSpace){if(e=Xp(e,1),t=ht(t,0,1),n=ht(n,0,1),t===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+t):n+t-n*t,o=2*n-r;this.r=$f(o,r,e+1/3),this.g=$f(o,r,e),this.b=$f(o,r,e-1/3)}return St.colorSpaceToWorking(this,s),this}setStyle(e,t=gi){function n(r){r!==void 0&&parseFloat(r)<1&&Ze("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:Ze("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);Ze("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=gi){let n=Yx[e.toLowerCase()];return n!==void 0?this.setHex(n,t):Ze("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Rs(e.r),this.g=Rs(e.g),this.b=Rs(e.b),this}copyLinearToSRGB(e){return this.r=Fo(e.r),this.g=Fo(e.g),this.b=Fo(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=gi){return St.workingToColorSpace(zn.copy(this),e),Math.round(ht(zn.r*255,0,255))*65536+Math.round(ht(zn.g*255,0,255))*256+Math.round(ht(zn.b*255,0,255))}getHexString(e=gi){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=St.workingColorSpace){St.workingToColorSpace(zn.copy(this),t);let n=zn.r,s=zn.g,r=zn.b,o=Math.max(n,s,r),a=Math.min(n,s,r),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let u=o-a;switch(c=h<=.5?u/(o+a):u/(2-o-a),o){case n:l=(s-r)/u+(s<r?6:0);break;case s:l=(r-n)/u+2;break;case r:l=(n-s)/u+4;break}l/=6}return e.h=l,e.s=c,e.l=h,e}getRGB(e,t=St.workingColorSpace){return St.workingToColorSpace(zn.copy(this),t),e.r=zn.r,e.g=zn.g,e.b=zn.b,e}getStyle(e=gi){St.workingToColorSpace(zn.copy(this),e);let t=zn.r,n=zn.g,s=zn.b;return e!==gi?`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(e,t,n){return this.getHSL(Qs),this.setHSL(Qs.h+e,Qs.s+t,Qs.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(Qs),e.getHSL(qc);let n=Ya(Qs.h,qc.h,t),s=Ya(Qs.s,qc.s,t),r=Ya(Qs.l,qc.l,t);return this.setHSL(n,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,n=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*n+r[6]*s,this.g=r[1]*t+r[4]*n+r[7]*s,this.b=r[2]*t+r[5]*n+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},zn=new ot;ot.NAMES=Yx;var $o=class extends wn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Is,this.environmentIntensity=1,this.environmentRotation=new Is,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},zi=new I,Es=new I,qf=new I,Ts=new I,Mo=new I,wo=new I,Vy=new I,Xf=new I,Yf=new I,jf=new I,Zf=new Jt,Kf=new Jt,Jf=new Jt,os=class i{constructor(e=new I,t=new I,n=new I){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,s){s.subVectors(n,t),zi.subVectors(e,t),s.cross(zi);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,n,s,r){zi.subVectors(s,t),Es.subVectors(n,t),qf.subVectors(e,t);let o=zi.dot(zi),a=zi.dot(Es),l=zi.dot(qf),c=Es.dot(Es),h=Es.dot(qf),u=o*c-a*a;if(u===0)return r.set(0,0,0),null;let d=1/u,f=(c*l-a*h)*d,p=(o*h-a*l)*d;return r.set(1-f-p,p,f)}static containsPoint(e,t,n,s){return this.getBarycoord(e,t,n,s,Ts)===null?!1:Ts.x>=0&&Ts.y>=0&&Ts.x+Ts.y<=1}static getInterpolation(e,t,n,s,r,o,a,l){return this.getBarycoord(e,t,n,s,Ts)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Ts.x),l.addScaledVector(o,Ts.y),l.addScaledVector(a,Ts.z),l)}static getInterpolatedAttribute(e,t,n,s,r,o){return Zf.setScalar(0),Kf.setScalar(0),Jf.setScalar(0),Zf.fromBufferAttribute(e,t),Kf.fromBufferAttribute(e,n),Jf.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(Zf,r.x),o.addScaledVector(Kf,r.y),o.addScaledVector(Jf,r.z),o}static isFrontFacing(e,t,n,s){return zi.subVectors(n,t),Es.subVectors(e,t),zi.cross(Es).dot(s)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,s){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,n,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return zi.subVectors(this.c,this.b),Es.subVectors(this.a,this.b),zi.cross(Es).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return i.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return i.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,s,r){return i.getInterpolation(e,this.a,this.b,this.c,t,n,s,r)}containsPoint(e){return i.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return i.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let n=this.a,s=this.b,r=this.c,o,a;Mo.subVectors(s,n),wo.subVectors(r,n),Xf.subVectors(e,n);let l=Mo.dot(Xf),c=wo.dot(Xf);if(l<=0&&c<=0)return t.copy(n);Yf.subVectors(e,s);let h=Mo.dot(Yf),u=wo.dot(Yf);if(h>=0&&u<=h)return t.copy(s);let d=l*u-h*c;if(d<=0&&l>=0&&h<=0&&l-h>0)return o=l/(l-h),t.copy(n).addScaledVector(Mo,o);jf.subVectors(e,r);let f=Mo.dot(jf),p=wo.dot(jf);if(p>=0&&f<=p)return t.copy(r);let _=f*c-l*p;if(_<=0&&c>=0&&p<=0)return a=c/(c-p),t.copy(n).addScaledVector(wo,a);let m=h*p-f*u;if(m<=0&&u-h>=0&&f-p>=0)return Vy.subVectors(r,s),a=(u-h)/(u-h+(f-p)),t.copy(s).addScaledVector(Vy,a);let g=1/(m+_+d);return o=_*g,a=d*g,t.copy(n).addScaledVector(Mo,o).addScaledVector(wo,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},ti=class{constructor(e=new I(1/0,1/0,1/0),t=new I(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint(Vi.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint(Vi.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=Vi.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let n=e.geometry;if(n!==void 0){let r=n.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Vi):Vi.fromBufferAttribute(r,o),Vi.applyMatrix4(e.matrixWorld),this.expandByPoint(Vi);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Xc.copy(e.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),Xc.copy(n.boundingBox)),Xc.applyMatrix4(e.matrixWorld),this.union(Xc)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Vi),Vi.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(za),Yc.subVectors(this.max,za),Eo.subVectors(e.a,za),To.subVectors(e.b,za),Ao.subVectors(e.c,za),er.subVectors(To,Eo),tr.subVectors(Ao,To),Dr.subVectors(Eo,Ao);let t=[0,-er.z,er.y,0,-tr.z,tr.y,0,-Dr.z,Dr.y,er.z,0,-er.x,tr.z,0,-tr.x,Dr.z,0,-Dr.x,-er.y,er.x,0,-tr.y,tr.x,0,-Dr.y,Dr.x,0];return!Qf(t,Eo,To,Ao,Yc)||(t=[1,0,0,0,1,0,0,0,1],!Qf(t,Eo,To,Ao,Yc))?!1:(jc.crossVectors(er,tr),t=[jc.x,jc.y,jc.z],Qf(t,Eo,To,Ao,Yc))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Vi).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Vi).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(As[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),As[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),As[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),As[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),As[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),As[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),As[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),As[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(As),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},As=[new I,new I,new I,new I,new I,new I,new I,new I],Vi=new I,Xc=new ti,Eo=new I,To=new I,Ao=new I,er=new I,tr=new I,Dr=new I,za=new I,Yc=new I,jc=new I,Nr=new I;function Qf(i,e,t,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){Nr.fromArray(i,r);let a=s.x*Math.abs(Nr.x)+s.y*Math.abs(Nr.y)+s.z*Math.abs(Nr.z),l=e.dot(Nr),c=t.dot(Nr),h=n.dot(Nr);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var _n=new I,Zc=new Se,eT=0,yi=class extends Gi{constructor(e,t,n=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:eT++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=n,this.usage=$p,this.updateRanges=[],this.gpuType=qi,this.version=0,this._normalizationScale=e!==void 0?Yu(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[n+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)Zc.fromBufferAttribute(this,t),Zc.applyMatrix3(e),this.setXY(t,Zc.x,Zc.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)_n.fromBufferAttribute(this,t),_n.applyMatrix3(e),this.setXYZ(t,_n.x,_n.y,_n.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)_n.fromBufferAttribute(this,t),_n.applyMatrix4(e),this.setXYZ(t,_n.x,_n.y,_n.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)_n.fromBufferAttribute(this,t),_n.applyNormalMatrix(e),this.setXYZ(t,_n.x,_n.y,_n.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)_n.fromBufferAttribute(this,t),_n.transformDirection(e),this.setXYZ(t,_n.x,_n.y,_n.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):jp(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Zp(e,this.array)}};var il=class extends yi{constructor(e,t,n){super(new Uint16Array(e),t,n)}};var sl=class extends yi{constructor(e,t,n){super(new Uint32Array(e),t,n)}};var ut=class extends yi{constructor(e,t,n){super(new Float32Array(e),t,n)}},tT=new ti,Va=new I,ep=new I,Ls=class{constructor(e=new I,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let n=this.center;t!==void 0?n.copy(t):tT.setFromPoints(e).getCenter(n);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,n.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;Va.subVectors(e,this.center);let t=Va.lengthSq();if(t>this.radius*this.radius){let n=Math.sqrt(t),s=(n-this.radius)*.5;this.center.addScaledVector(Va,s/n),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(ep.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(Va.copy(e.center).add(ep)),this.expandByPoint(Va.copy(e.center).sub(ep))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},nT=0,Ti=new yt,tp=new wn,Co=new I,mi=new ti,Ga=new ti,Nn=new I,Nt=class i extends Gi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:nT++}),this.uuid=pr(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(AE(e)?sl:il)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new it().getNormalMatrix(e);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Ti.makeRotationFromQuaternion(e),this.applyMatrix4(Ti),this}rotateX(e){return Ti.makeRotationX(e),this.applyMatrix4(Ti),this}rotateY(e){return Ti.makeRotationY(e),this.applyMatrix4(Ti),this}rotateZ(e){return Ti.makeRotationZ(e),this.applyMatrix4(Ti),this}translate(e,t,n){return Ti.makeTranslation(e,t,n),this.applyMatrix4(Ti),this}scale(e,t,n){return Ti.makeScale(e,t,n),this.applyMatrix4(Ti),this}lookAt(e){return tp.lookAt(e),tp.updateMatrix(),this.applyMatrix4(tp.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Co).negate(),this.translate(Co.x,Co.y,Co.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let n=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new ut(n,3))}else{let n=Math.min(e.length,t.count);for(let s=0;s<n;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&Ze("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new ti);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){Qe("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new I(-1/0,-1/0,-1/0),new I(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,s=t.length;n<s;n++){let r=t[n];mi.setFromBufferAttribute(r),this.morphTargetsRelative?(Nn.addVectors(this.boundingBox.min,mi.min),this.boundingBox.expandByPoint(Nn),Nn.addVectors(this.boundingBox.max,mi.max),this.boundingBox.expandByPoint(Nn)):(this.boundingBox.expandByPoint(mi.min),this.boundingBox.expandByPoint(mi.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&Qe('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Ls);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){Qe("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new I,1/0);return}if(e){let n=this.boundingSphere.center;if(mi.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];Ga.setFromBufferAttribute(a),this.morphTargetsRelative?(Nn.addVectors(mi.min,Ga.min),mi.expandByPoint(Nn),Nn.addVectors(mi.max,Ga.max),mi.expandByPoint(Nn)):(mi.expandByPoint(Ga.min),mi.expandByPoint(Ga.max))}mi.getCenter(n);let s=0;for(let r=0,o=e.count;r<o;r++)Nn.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(Nn));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)Nn.fromBufferAttribute(a,c),l&&(Co.fromBufferAttribute(e,c),Nn.add(Co)),s=Math.max(s,n.distanceToSquared(Nn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&Qe('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){Qe("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new yi(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(n.count);for(let U=0;U<n.count;U++)a[U]=new I,l[U]=new I;let h=new I,u=new I,d=new I,f=new Se,p=new Se,_=new Se,m=new I,g=new I;function x(U,N,L){c[U]=c[N]=c[L]=1,h.fromBufferAttribute(n,U),u.fromBufferAttribute(n,N),d.fromBufferAttribute(n,L),f.fromBufferAttribute(r,U),p.fromBufferAttribute(r,N),_.fromBufferAttribute(r,L),u.sub(h),d.sub(h),p.sub(f),_.sub(f);let V=1/(p.x*_.y-_.x*p.y);isFinite(V)&&(m.copy(u).multiplyScalar(_.y).addScaledVector(d,-p.y).multiplyScalar(V),g.copy(d).multiplyScalar(p.x).addScaledVector(u,-_.x).multiplyScalar(V),a[U].add(m),a[N].add(m),a[L].add(m),l[U].add(g),l[N].add(g),l[L].add(g))}let C=this.groups;C.length===0&&(C=[{start:0,count:e.count}]);for(let U=0,N=C.length;U<N;++U){let L=C[U],V=L.start,W=L.count;for(let O=V,G=V+W;O<G;O+=3)x(e.getX(O+0),e.getX(O+1),e.getX(O+2))}let b=new I,A=new I,S=new I,y=new I;function M(U){S.fromBufferAttribute(s,U),y.copy(S);let N=a[U];b.copy(N),b.sub(S.multiplyScalar(S.dot(N))).normalize(),A.crossVectors(y,N);let V=A.dot(l[U])<0?-1:1;o.setXYZW(U,b.x,b.y,b.z,V)}for(let U=0,N=n.count;U<N;++U)c[U]&&M(U);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==t.count)n=new yi(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let d=0,f=n.count;d<f;d++)n.setXYZ(d,0,0,0);let s=new I,r=new I,o=new I,a=new I,l=new I,c=new I,h=new I,u=new I;if(e)for(let d=0,f=e.count;d<f;d+=3){let p=e.getX(d+0),_=e.getX(d+1),m=e.getX(d+2);s.fromBufferAttribute(t,p),r.fromBufferAttribute(t,_),o.fromBufferAttribute(t,m),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),a.fromBufferAttribute(n,p),l.fromBufferAttribute(n,_),c.fromBufferAttribute(n,m),a.add(h),l.add(h),c.add(h),n.setXYZ(p,a.x,a.y,a.z),n.setXYZ(_,l.x,l.y,l.z),n.setXYZ(m,c.x,c.y,c.z)}else for(let d=0,f=t.count;d<f;d+=3)s.fromBufferAttribute(t,d+0),r.fromBufferAttribute(t,d+1),o.fromBufferAttribute(t,d+2),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),n.setXYZ(d+0,h.x,h.y,h.z),n.setXYZ(d+1,h.x,h.y,h.z),n.setXYZ(d+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)Nn.fromBufferAttribute(e,t),Nn.normalize(),e.setXYZ(t,Nn.x,Nn.y,Nn.z)}toNonIndexed(){function e(a,l){let c=a.array,h=a.itemSize,u=a.normalized,d=new c.constructor(l.length*h),f=0,p=0;for(let _=0,m=l.length;_<m;_++){a.isInterleavedBufferAttribute?f=l[_]*a.data.stride+a.offset:f=l[_]*h;for(let g=0;g<h;g++)d[p++]=c[f++]}return new yi(d,h,u)}if(this.index===null)return Ze("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new i,n=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,n);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let h=0,u=c.length;h<u;h++){let d=c[h],f=e(d,n);l.push(f)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let n=this.attributes;for(let l in n){let c=n[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let u=0,d=c.length;u<d;u++){let f=c[u];h.push(f.toJSON(e.data))}h.length>0&&(s[l]=h,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let n=e.index;n!==null&&this.setIndex(n.clone());let s=e.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(t))}let r=e.morphAttributes;for(let c in r){let h=[],u=r[c];for(let d=0,f=u.length;d<f;d++)h.push(u[d].clone(t));this.morphAttributes[c]=h}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,h=o.length;c<h;c++){let u=o[c];this.addGroup(u.start,u.count,u.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},Nh=class{constructor(e,t){this.isInterleavedBuffer=!0,this.array=e,this.stride=t,this.count=e!==void 0?e.length/t:0,this.usage=$p,this.updateRanges=[],this.version=0,this.uuid=pr()}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.array=new e.array.constructor(e.array),this.count=e.count,this.stride=e.stride,this.usage=e.usage,this}copyAt(e,t,n){e*=this.stride,n*=t.stride;for(let s=0,r=this.stride;s<r;s++)this.array[e+s]=t.array[n+s];return this}set(e,t=0){return this.array.set(e,t),this}clone(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=Gy(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=this.array.slice(0).buffer);let n=new this.array.constructor(e.arrayBuffers[t]),s=new this.constructor(n,this.stride);return s.setUsage(this.usage),s}onUpload(e){return this.onUploadCallback=e,this}toJSON(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=Gy(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let n={uuid:this.uuid,buffer:t,type:this.array.constructor.name,stride:this.stride};return n.usage=this.usage,n}};function Gy(i){return i.buffer._uuid===void 0&&(i.buffer._uuid=pr()),i.byteOffset===0&&i.byteLength===i.buffer.byteLength?i.buffer._uuid:i.buffer._uuid+":"+i.byteOffset+":"+i.byteLength}var jn=new I,rl=class i{constructor(e,t,n,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=e,this.itemSize=t,this.offset=n,this.normalized=s,this._normalizationScale=e!==void 0?Yu(e.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(e){this.data.needsUpdate=e}applyMatrix4(e){for(let t=0,n=this.data.count;t<n;t++)jn.fromBufferAttribute(this,t),jn.applyMatrix4(e),this.setXYZ(t,jn.x,jn.y,jn.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)jn.fromBufferAttribute(this,t),jn.applyNormalMatrix(e),this.setXYZ(t,jn.x,jn.y,jn.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)jn.fromBufferAttribute(this,t),jn.transformDirection(e),this.setXYZ(t,jn.x,jn.y,jn.z);return this}getComponent(e,t){let n=this.array[e*this.data.stride+this.offset+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.data.array[e*this.data.stride+this.offset+t]=n,this}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset]=t,this}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+1]=t,this}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+2]=t,this}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+3]=t,this}getX(e){let t=this.data.array[e*this.data.stride+this.offset];return this.normalized&&(t=this._denormalize(t)),t}getY(e){let t=this.data.array[e*this.data.stride+this.offset+1];return this.normalized&&(t=this._denormalize(t)),t}getZ(e){let t=this.data.array[e*this.data.stride+this.offset+2];return this.normalized&&(t=this._denormalize(t)),t}getW(e){let t=this.data.array[e*this.data.stride+this.offset+3];return this.normalized&&(t=this._denormalize(t)),t}setXY(e,t,n){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.data.array[e+0]=t,this.data.array[e+1]=n,this}setXYZ(e,t,n,s){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s)),this.data.array[e+0]=t,this.data.array[e+1]=n,this.data.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.data.array[e+0]=t,this.data.array[e+1]=n,this.data.array[e+2]=s,this.data.array[e+3]=r,this}clone(e){if(e===void 0){tl("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return new yi(new this.array.constructor(t),this.itemSize,this.normalized)}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.clone(e)),new i(e.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(e){if(e===void 0){tl("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:t,normalized:this.normalized}}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.toJSON(e)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):jp(e,this.data.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Zp(e,this.data.array)}},np=new I,iT=new I,sT=new it,_i=class{constructor(e=new I(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,s){return this.normal.set(e,t,n),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){let s=np.subVectors(n,t).cross(iT.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,n=!0){let s=e.delta(np),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return n===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let n=t||sT.getNormalMatrix(e),s=this.coplanarPoint(np).applyMatrix4(e),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},rT=0,ls=class extends Gi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:rT++}),this.uuid=pr(),this.name="",this.type="Material",this.blending=dr,this.side=ur,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Ep,this.blendDst=Tp,this.blendEquation=Br,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new ot(0,0,0),this.blendAlpha=0,this.depthFunc=ko,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=kx,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=vh,this.stencilZFail=vh,this.stencilZPass=vh,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let n=e[t];if(n===void 0){Ze(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ze(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new ot().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(n=>new _i().fromJSON(n))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let n=e.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new Se().fromArray(n)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Se().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,n=null;if(t!==null){let s=t.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=t[r].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}},qo=class extends ls{constructor(e){super(),this.isSpriteMaterial=!0,this.type="SpriteMaterial",this.color=new ot(16777215),this.map=null,this.alphaMap=null,this.rotation=0,this.sizeAttenuation=!0,this.transparent=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.alphaMap=e.alphaMap,this.rotation=e.rotation,this.sizeAttenuation=e.sizeAttenuation,this.fog=e.fog,this}},Ro,Ha=new I,Po=new I,Io=new I,Lo=new Se,Wa=new Se,jx=new yt,Kc=new I,$a=new I,Jc=new I,Hy=new Se,ip=new Se,Wy=new Se,ol=class extends wn{constructor(e=new qo){if(super(),this.isSprite=!0,this.type="Sprite",Ro===void 0){Ro=new Nt;let t=new Float32Array([-.5,-.5,0,0,0,.5,-.5,0,1,0,.5,.5,0,1,1,-.5,.5,0,0,1]),n=new Nh(t,5);Ro.setIndex([0,1,2,0,2,3]),Ro.setAttribute("position",new rl(n,3,0,!1)),Ro.setAttribute("uv",new rl(n,2,3,!1))}this.geometry=Ro,this.material=e,this.center=new Se(.5,.5),this.count=1}intersectsFrustum(e){return e.intersectsSprite(this)}raycast(e,t){e.camera===null&&Qe('Sprite: "Raycaster.camera" needs to be set in order to raycast against sprites.'),Po.setFromMatrixScale(this.matrixWorld),jx.copy(e.camera.matrixWorld),this.modelViewMatrix.multiplyMatrices(e.camera.matrixWorldInverse,this.matrixWorld),Io.setFromMatrixPosition(this.modelViewMatrix),e.camera.isPerspectiveCamera&&this.material.sizeAttenuation===!1&&Po.multiplyScalar(-Io.z);let n=this.material.rotation,s,r;n!==0&&(r=Math.cos(n),s=Math.sin(n));let o=this.center;Qc(Kc.set(-.5,-.5,0),Io,o,Po,s,r),Qc($a.set(.5,-.5,0),Io,o,Po,s,r),Qc(Jc.set(.5,.5,0),Io,o,Po,s,r),Hy.set(0,0),ip.set(1,0),Wy.set(1,1);let a=e.ray.intersectTriangle(Kc,$a,Jc,!1,Ha);if(a===null&&(Qc($a.set(-.5,.5,0),Io,o,Po,s,r),ip.set(0,1),a=e.ray.intersectTriangle(Kc,Jc,$a,!1,Ha),a===null))return;let l=e.ray.origin.distanceTo(Ha);l<e.near||l>e.far||t.push({distance:l,point:Ha.clone(),uv:os.getInterpolation(Ha,Kc,$a,Jc,Hy,ip,Wy,new Se),face:null,object:this})}copy(e,t){return super.copy(e,t),e.center!==void 0&&this.center.copy(e.center),this.material=e.material,this}toJSON(e){let t=super.toJSON(e);return t.object.center=this.center.toArray(),t}};function Qc(i,e,t,n,s,r){Lo.subVectors(i,t).addScalar(.5).multiply(n),s!==void 0?(Wa.x=r*Lo.x-s*Lo.y,Wa.y=s*Lo.x+r*Lo.y):Wa.copy(Lo),i.copy(e),i.x+=Wa.x,i.y+=Wa.y,i.applyMatrix4(jx)}var Cs=new I,sp=new I,eh=new I,th=new I,ir=class{constructor(e=new I,t=new I(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Cs)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=Cs.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Cs.copy(this.origin).addScaledVector(this.direction,t),Cs.distanceToSquared(e))}distanceSqToSegment(e,t,n,s){sp.copy(e).add(t).multiplyScalar(.5),eh.copy(t).sub(e).normalize(),th.copy(this.origin).sub(sp);let r=e.distanceTo(t)*.5,o=-this.direction.dot(eh),a=th.dot(this.direction),l=-th.dot(eh),c=th.lengthSq(),h=Math.abs(1-o*o),u,d,f,p;if(h>0)if(u=o*l-a,d=o*a-l,p=r*h,u>=0)if(d>=-p)if(d<=p){let _=1/h;u*=_,d*=_,f=u*(u+o*d+2*a)+d*(o*u+d+2*l)+c}else d=r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;else d=-r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;else d<=-p?(u=Math.max(0,-(-o*r+a)),d=u>0?-r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+c):d<=p?(u=0,d=Math.min(Math.max(-r,-l),r),f=d*(d+2*l)+c):(u=Math.max(0,-(o*r+a)),d=u>0?r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+c);else d=o>0?-r:r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(sp).addScaledVector(eh,d),f}intersectSphere(e,t){if(e.radius<0)return null;Cs.subVectors(e.center,this.origin);let n=Cs.dot(this.direction),s=Cs.dot(Cs)-n*n,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){let n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,s,r,o,a,l,c=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,d=this.origin;return c>=0?(n=(e.min.x-d.x)*c,s=(e.max.x-d.x)*c):(n=(e.max.x-d.x)*c,s=(e.min.x-d.x)*c),h>=0?(r=(e.min.y-d.y)*h,o=(e.max.y-d.y)*h):(r=(e.max.y-d.y)*h,o=(e.min.y-d.y)*h),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),u>=0?(a=(e.min.z-d.z)*u,l=(e.max.z-d.z)*u):(a=(e.max.z-d.z)*u,l=(e.min.z-d.z)*u),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,t)}intersectsBox(e){return this.intersectBox(e,Cs)!==null}intersectTriangle(e,t,n,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,h=a.z,u=e.x-o.x,d=e.y-o.y,f=e.z-o.z,p=t.x-o.x,_=t.y-o.y,m=t.z-o.z,g=n.x-o.x,x=n.y-o.y,C=n.z-o.z,b=Math.abs(l),A=Math.abs(c),S=Math.abs(h),y,M,U,N,L,V,W,O,G,j,z,ce;if(b>=A&&b>=S?(U=l,V=u,G=p,ce=g,l>=0?(y=c,M=h,N=d,L=f,W=_,O=m,j=x,z=C):(y=h,M=c,N=f,L=d,W=m,O=_,j=C,z=x)):A>=S?(U=c,V=d,G=_,ce=x,c>=0?(y=h,M=l,N=f,L=u,W=m,O=p,j=C,z=g):(y=l,M=h,N=u,L=f,W=p,O=m,j=g,z=C)):(U=h,V=f,G=m,ce=C,h>=0?(y=l,M=c,N=u,L=d,W=p,O=_,j=g,z=x):(y=c,M=l,N=d,L=u,W=_,O=p,j=x,z=g)),U===0)return null;let Z=y/U,J=M/U,ie=1/U,fe=N-Z*V,de=L-J*V,Q=W-Z*G,ge=O-J*G,xe=j-Z*ce,Pe=z-J*ce,we=xe*ge-Pe*Q,Xe=fe*Pe-de*xe,at=Q*de-ge*fe;if(s){if(we<0||Xe<0||at<0)return null}else if((we<0||Xe<0||at<0)&&(we>0||Xe>0||at>0))return null;let $e=we+Xe+at;if($e===0)return null;let mt=ie*(we*V+Xe*G+at*ce);return($e>0?mt<0:mt>0)?null:this.at(mt/$e,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Hi=class extends ls{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new ot(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Is,this.combine=Qo,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},$y=new yt,Or=new ir,nh=new Ls,qy=new I,ih=new I,sh=new I,rh=new I,rp=new I,oh=new I,Xy=new I,ah=new I,Mt=class extends wn{constructor(e=new Nt,t=new Hi){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){oh.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=a[l],u=r[l];h!==0&&(rp.fromBufferAttribute(u,e),o?oh.addScaledVector(rp,h):oh.addScaledVector(rp.sub(t),h))}t.add(oh)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),nh.copy(n.boundingSphere),nh.applyMatrix4(r),Or.copy(e.ray).recast(e.near),!(nh.containsPoint(Or.origin)===!1&&(Or.intersectSphere(nh,qy)===null||Or.origin.distanceToSquared(qy)>(e.far-e.near)**2))&&($y.copy(r).invert(),Or.copy(e.ray).applyMatrix4($y),!(n.boundingBox!==null&&Or.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(e,t,Or)))}_computeIntersections(e,t,n){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,u=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,_=d.length;p<_;p++){let m=d[p],g=o[m.materialIndex],x=Math.max(m.start,f.start),C=Math.min(a.count,Math.min(m.start+m.count,f.start+f.count));for(let b=x,A=C;b<A;b+=3){let S=a.getX(b),y=a.getX(b+1),M=a.getX(b+2);s=lh(this,g,e,n,c,h,u,S,y,M),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let p=Math.max(0,f.start),_=Math.min(a.count,f.start+f.count);for(let m=p,g=_;m<g;m+=3){let x=a.getX(m),C=a.getX(m+1),b=a.getX(m+2);s=lh(this,o,e,n,c,h,u,x,C,b),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let p=0,_=d.length;p<_;p++){let m=d[p],g=o[m.materialIndex],x=Math.max(m.start,f.start),C=Math.min(l.count,Math.min(m.start+m.count,f.start+f.count));for(let b=x,A=C;b<A;b+=3){let S=b,y=b+1,M=b+2;s=lh(this,g,e,n,c,h,u,S,y,M),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let p=Math.max(0,f.start),_=Math.min(l.count,f.start+f.count);for(let m=p,g=_;m<g;m+=3){let x=m,C=m+1,b=m+2;s=lh(this,o,e,n,c,h,u,x,C,b),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}}};function oT(i,e,t,n,s,r,o,a){let l;if(e.side===Qn?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,e.side===ur,a),l===null)return null;ah.copy(a),ah.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(ah);return c<t.near||c>t.far?null:{distance:c,point:ah.clone(),object:i}}function lh(i,e,t,n,s,r,o,a,l,c){i.getVertexPosition(a,ih),i.getVertexPosition(l,sh),i.getVertexPosition(c,rh);let h=oT(i,e,t,n,ih,sh,rh,Xy);if(h){let u=new I;os.getBarycoord(Xy,ih,sh,rh,u),s&&(h.uv=os.getInterpolatedAttribute(s,a,l,c,u,new Se)),r&&(h.uv1=os.getInterpolatedAttribute(r,a,l,c,u,new Se)),o&&(h.normal=os.getInterpolatedAttribute(o,a,l,c,u,new I),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));let d={a,b:l,c,normal:new I,materialIndex:0};os.getNormal(ih,sh,rh,d.normal),h.face=d,h.barycoord=u}return h}var Oh=class extends Jn{constructor(e=null,t=1,n=1,s,r,o,a,l,c=On,h=On,u,d){super(null,o,a,l,c,h,s,r,u,d),this.isDataTexture=!0,this.image={data:e,width:t,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Ur=new Ls,aT=new Se(.5,.5),ch=new I,sr=class{constructor(e=new _i,t=new _i,n=new _i,s=new _i,r=new _i,o=new _i){this.planes=[e,t,n,s,r,o]}set(e,t,n,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=Ai,n=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],h=r[4],u=r[5],d=r[6],f=r[7],p=r[8],_=r[9],m=r[10],g=r[11],x=r[12],C=r[13],b=r[14],A=r[15];if(s[0].setComponents(c-o,f-h,g-p,A-x).normalize(),s[1].setComponents(c+o,f+h,g+p,A+x).normalize(),s[2].setComponents(c+a,f+u,g+_,A+C).normalize(),s[3].setComponents(c-a,f-u,g-_,A-C).normalize(),n)s[4].setComponents(l,d,m,b).normalize(),s[5].setComponents(c-l,f-d,g-m,A-b).normalize();else if(s[4].setComponents(c-l,f-d,g-m,A-b).normalize(),t===Ai)s[5].setComponents(c+l,f+d,g+m,A+b).normalize();else if(t===Bo)s[5].setComponents(l,d,m,b).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),Ur.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),Ur.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(Ur)}intersectsSprite(e){Ur.center.set(0,0,0);let t=aT.distanceTo(e.center);return Ur.radius=.7071067811865476+t,Ur.applyMatrix4(e.matrixWorld),this.intersectsSphere(Ur)}intersectsSphere(e){let t=this.planes,n=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let n=0;n<6;n++){let s=t[n];if(ch.x=s.normal.x>0?e.max.x:e.min.x,ch.y=s.normal.y>0?e.max.y:e.min.y,ch.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(ch)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Yy=new yt,Uh=class i{constructor(){this.coordinateSystem=Ai,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,n=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];Yy.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new sr),n[s].setFromProjectionMatrix(Yy,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,n=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new sr),t[s].copy(n[s]);return this._count=e._count,this}clone(){return new i().copy(this)}};var en=class extends ls{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new ot(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},Fh=new I,kh=new I,jy=new yt,qa=new ir,hh=new Ls,op=new I,Zy=new I,Ci=class extends wn{constructor(e=new Nt,t=new en){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[0];for(let s=1,r=t.count;s<r;s++)Fh.fromBufferAttribute(t,s-1),kh.fromBufferAttribute(t,s),n[s]=n[s-1],n[s]+=Fh.distanceTo(kh);e.setAttribute("lineDistance",new ut(n,1))}else Ze("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),hh.copy(n.boundingSphere),hh.applyMatrix4(s),hh.radius+=r,e.ray.intersectsSphere(hh)===!1)return;jy.copy(s).invert(),qa.copy(e.ray).applyMatrix4(jy);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,h=n.index,d=n.attributes.position;if(h!==null){let f=Math.max(0,o.start),p=Math.min(h.count,o.start+o.count);for(let _=f,m=p-1;_<m;_+=c){let g=h.getX(_),x=h.getX(_+1),C=uh(this,e,qa,l,g,x,_);C&&t.push(C)}if(this.isLineLoop){let _=h.getX(p-1),m=h.getX(f),g=uh(this,e,qa,l,_,m,p-1);g&&t.push(g)}}else{let f=Math.max(0,o.start),p=Math.min(d.count,o.start+o.count);for(let _=f,m=p-1;_<m;_+=c){let g=uh(this,e,qa,l,_,_+1,_);g&&t.push(g)}if(this.isLineLoop){let _=uh(this,e,qa,l,p-1,f,p-1);_&&t.push(_)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function uh(i,e,t,n,s,r,o){let a=i.geometry.attributes.position;if(Fh.fromBufferAttribute(a,s),kh.fromBufferAttribute(a,r),t.distanceSqToSegment(Fh,kh,op,Zy)>n)return;op.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(op);if(!(c<e.near||c>e.far))return{distance:c,point:Zy.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var Ky=new I,Jy=new I,vi=class extends Ci{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[];for(let s=0,r=t.count;s<r;s+=2)Ky.fromBufferAttribute(t,s),Jy.fromBufferAttribute(t,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+Ky.distanceTo(Jy);e.setAttribute("lineDistance",new ut(n,1))}else Ze("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var al=class extends Jn{constructor(e=[],t=zr,n,s,r,o,a,l,c,h){super(e,t,n,s,r,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}},ll=class extends Jn{constructor(e,t,n,s,r,o,a,l,c){super(e,t,n,s,r,o,a,l,c),this.isCanvasTexture=!0,this.needsUpdate=!0}};var Ds=class extends Jn{constructor(e,t,n=$i,s,r,o,a=On,l=On,c,h=Ps,u=1){if(h!==Ps&&h!==Fs)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:e,height:t,depth:u};super(d,s,r,o,a,l,h,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Go(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},cl=class extends Ds{constructor(e,t=$i,n=zr,s,r,o=On,a=On,l,c=Ps){let h={width:e,height:e,depth:1},u=[h,h,h,h,h,h];super(e,e,t,n,s,r,o,a,l,c),this.image=u,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},hl=class extends Jn{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},Wi=class i extends Nt{constructor(e=1,t=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],h=[],u=[],d=0,f=0;p("z","y","x",-1,-1,n,t,e,o,r,0),p("z","y","x",1,-1,n,t,-e,o,r,1),p("x","z","y",1,1,e,n,t,s,o,2),p("x","z","y",1,-1,e,n,-t,s,o,3),p("x","y","z",1,-1,e,t,n,s,r,4),p("x","y","z",-1,-1,e,t,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new ut(c,3)),this.setAttribute("normal",new ut(h,3)),this.setAttribute("uv",new ut(u,2));function p(_,m,g,x,C,b,A,S,y,M,U){let N=b/y,L=A/M,V=b/2,W=A/2,O=S/2,G=y+1,j=M+1,z=0,ce=0,Z=new I;for(let J=0;J<j;J++){let ie=J*L-W;for(let fe=0;fe<G;fe++){let de=fe*N-V;Z[_]=de*x,Z[m]=ie*C,Z[g]=O,c.push(Z.x,Z.y,Z.z),Z[_]=0,Z[m]=0,Z[g]=S>0?1:-1,h.push(Z.x,Z.y,Z.z),u.push(fe/y),u.push(1-J/M),z+=1}}for(let J=0;J<M;J++)for(let ie=0;ie<y;ie++){let fe=d+ie+G*J,de=d+ie+G*(J+1),Q=d+(ie+1)+G*(J+1),ge=d+(ie+1)+G*J;l.push(fe,de,ge),l.push(de,Q,ge),ce+=6}a.addGroup(f,ce,U),f+=ce,d+=z}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var ul=class i extends Nt{constructor(e=1,t=32,n=0,s=Math.PI*2){super(),this.type="CircleGeometry",this.parameters={radius:e,segments:t,thetaStart:n,thetaLength:s},t=Math.max(3,t);let r=[],o=[],a=[],l=[],c=new I,h=new Se;o.push(0,0,0),a.push(0,0,1),l.push(.5,.5);for(let u=0,d=3;u<=t;u++,d+=3){let f=n+u/t*s;c.x=e*Math.cos(f),c.y=e*Math.sin(f),o.push(c.x,c.y,c.z),a.push(0,0,1),h.x=(o[d]/e+1)/2,h.y=(o[d+1]/e+1)/2,l.push(h.x,h.y)}for(let u=1;u<=t;u++)r.push(u,u+1,0);this.setIndex(r),this.setAttribute("position",new ut(o,3)),this.setAttribute("normal",new ut(a,3)),this.setAttribute("uv",new ut(l,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.segments,e.thetaStart,e.thetaLength)}},rr=class i extends Nt{constructor(e=1,t=1,n=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:n,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let h=[],u=[],d=[],f=[],p=0,_=[],m=n/2,g=0;x(),o===!1&&(e>0&&C(!0),t>0&&C(!1)),this.setIndex(h),this.setAttribute("position",new ut(u,3)),this.setAttribute("normal",new ut(d,3)),this.setAttribute("uv",new ut(f,2));function x(){let b=new I,A=new I,S=0,y=(t-e)/n;for(let M=0;M<=r;M++){let U=[],N=M/r,L=N*(t-e)+e;for(let V=0;V<=s;V++){let W=V/s,O=W*l+a,G=Math.sin(O),j=Math.cos(O);A.x=L*G,A.y=-N*n+m,A.z=L*j,u.push(A.x,A.y,A.z),b.set(G,y,j).normalize(),d.push(b.x,b.y,b.z),f.push(W,1-N),U.push(p++)}_.push(U)}for(let M=0;M<s;M++)for(let U=0;U<r;U++){let N=_[U][M],L=_[U+1][M],V=_[U+1][M+1],W=_[U][M+1];(e>0||U!==0)&&(h.push(N,L,W),S+=3),(t>0||U!==r-1)&&(h.push(L,V,W),S+=3)}c.addGroup(g,S,0),g+=S}function C(b){let A=p,S=new Se,y=new I,M=0,U=b===!0?e:t,N=b===!0?1:-1;for(let V=1;V<=s;V++)u.push(0,m*N,0),d.push(0,N,0),f.push(.5,.5),p++;let L=p;for(let V=0;V<=s;V++){let O=V/s*l+a,G=Math.cos(O),j=Math.sin(O);y.x=U*j,y.y=m*N,y.z=U*G,u.push(y.x,y.y,y.z),d.push(0,N,0),S.x=G*.5+.5,S.y=j*.5*N+.5,f.push(S.x,S.y),p++}for(let V=0;V<s;V++){let W=A+V,O=L+V;b===!0?h.push(O,O+1,W):h.push(O+1,O,W),M+=3}c.addGroup(g,M,b===!0?1:2),g+=M}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}},Xo=class i extends rr{constructor(e=1,t=1,n=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,e,t,n,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:e,height:t,radialSegments:n,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(e){return new i(e.radius,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var dh=new I,fh=new I,ap=new I,ph=new os,Fr=class extends Nt{constructor(e=null,t=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:e,thresholdAngle:t},e!==null){let s=Math.pow(10,4),r=Math.cos(Uo*t),o=e.getIndex(),a=e.getAttribute("position"),l=o?o.count:a.count,c=[0,0,0],h=["a","b","c"],u=new Array(3),d=new Map,f=[];for(let p=0;p<l;p+=3){o?(c[0]=o.getX(p),c[1]=o.getX(p+1),c[2]=o.getX(p+2)):(c[0]=p,c[1]=p+1,c[2]=p+2);let{a:_,b:m,c:g}=ph;if(_.fromBufferAttribute(a,c[0]),m.fromBufferAttribute(a,c[1]),g.fromBufferAttribute(a,c[2]),ph.getNormal(ap),u[0]=`${Math.round(_.x*s)},${Math.round(_.y*s)},${Math.round(_.z*s)}`,u[1]=`${Math.round(m.x*s)},${Math.round(m.y*s)},${Math.round(m.z*s)}`,u[2]=`${Math.round(g.x*s)},${Math.round(g.y*s)},${Math.round(g.z*s)}`,!(u[0]===u[1]||u[1]===u[2]||u[2]===u[0]))for(let x=0;x<3;x++){let C=(x+1)%3,b=u[x],A=u[C],S=ph[h[x]],y=ph[h[C]],M=`${b}_${A}`,U=`${A}_${b}`,N=d.get(U);N?(ap.dot(N.normal)<=r&&(f.push(S.x,S.y,S.z),f.push(y.x,y.y,y.z)),d.set(U,null)):d.has(M)||d.set(M,{index0:c[x],index1:c[C],normal:ap.clone()})}}for(let p of d.values())if(p){let{index0:_,index1:m}=p;dh.fromBufferAttribute(a,_),fh.fromBufferAttribute(a,m),f.push(dh.x,dh.y,dh.z),f.push(fh.x,fh.y,fh.z)}this.setAttribute("position",new ut(f,3))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}},ni=class{constructor(){this.type="Curve",this.arcLengthDivisions=200,this.needsUpdate=!1,this.cacheArcLengths=null}getPoint(){Ze("Curve: .getPoint() not implemented.")}getPointAt(e,t){let n=this.getUtoTmapping(e);return this.getPoint(n,t)}getPoints(e=5){let t=[];for(let n=0;n<=e;n++)t.push(this.getPoint(n/e));return t}getSpacedPoints(e=5){let t=[];for(let n=0;n<=e;n++)t.push(this.getPointAt(n/e));return t}getLength(){let e=this.getLengths();return e[e.length-1]}getLengths(e=this.arcLengthDivisions){if(this.cacheArcLengths&&this.cacheArcLengths.length===e+1&&!this.needsUpdate)return this.cacheArcLengths;this.needsUpdate=!1;let t=[],n,s=this.getPoint(0),r=0;t.push(0);for(let o=1;o<=e;o++)n=this.getPoint(o/e),r+=n.distanceTo(s),t.push(r),s=n;return this.cacheArcLengths=t,t}updateArcLengths(){this.needsUpdate=!0,this.getLengths()}getUtoTmapping(e,t=null){let n=this.getLengths(),s=0,r=n.length,o;t?o=t:o=e*n[r-1];let a=0,l=r-1,c;for(;a<=l;)if(s=Math.floor(a+(l-a)/2),c=n[s]-o,c<0)a=s+1;else if(c>0)l=s-1;else{l=s;break}if(s=l,n[s]===o)return s/(r-1);let h=n[s],d=n[s+1]-h,f=(o-h)/d;return(s+f)/(r-1)}getTangent(e,t){let s=e-1e-4,r=e+1e-4;s<0&&(s=0),r>1&&(r=1);let o=this.getPoint(s),a=this.getPoint(r),l=t||(o.isVector2?new Se:new I);return l.copy(a).sub(o).normalize(),l}getTangentAt(e,t){let n=this.getUtoTmapping(e);return this.getTangent(n,t)}computeFrenetFrames(e,t=!1){let n=new I,s=[],r=[],o=[],a=new I,l=new yt;for(let f=0;f<=e;f++){let p=f/e;s[f]=this.getTangentAt(p,new I)}r[0]=new I,o[0]=new I;let c=Number.MAX_VALUE,h=Math.abs(s[0].x),u=Math.abs(s[0].y),d=Math.abs(s[0].z);h<=c&&(c=h,n.set(1,0,0)),u<=c&&(c=u,n.set(0,1,0)),d<=c&&n.set(0,0,1),a.crossVectors(s[0],n).normalize(),r[0].crossVectors(s[0],a),o[0].crossVectors(s[0],r[0]);for(let f=1;f<=e;f++){if(r[f]=r[f-1].clone(),o[f]=o[f-1].clone(),a.crossVectors(s[f-1],s[f]),a.length()>Number.EPSILON){a.normalize();let p=Math.acos(ht(s[f-1].dot(s[f]),-1,1));r[f].applyMatrix4(l.makeRotationAxis(a,p))}o[f].crossVectors(s[f],r[f])}if(t===!0){let f=Math.acos(ht(r[0].dot(r[e]),-1,1));f/=e,s[0].dot(a.crossVectors(r[0],r[e]))>0&&(f=-f);for(let p=1;p<=e;p++)r[p].applyMatrix4(l.makeRotationAxis(s[p],f*p)),o[p].crossVectors(s[p],r[p])}return{tangents:s,normals:r,binormals:o}}clone(){return new this.constructor().copy(this)}copy(e){return this.arcLengthDivisions=e.arcLengthDivisions,this.cacheArcLengths=null,this}toJSON(){let e={metadata:{version:4.7,type:"Curve",generator:"Curve.toJSON"}};return e.arcLengthDivisions=this.arcLengthDivisions,e.type=this.type,e}fromJSON(e){return this.arcLengthDivisions=e.arcLengthDivisions,this.cacheArcLengths=null,this}},dl=class extends ni{constructor(e=0,t=0,n=1,s=1,r=0,o=Math.PI*2,a=!1,l=0){super(),this.isEllipseCurve=!0,this.type="EllipseCurve",this.aX=e,this.aY=t,this.xRadius=n,this.yRadius=s,this.aStartAngle=r,this.aEndAngle=o,this.aClockwise=a,this.aRotation=l}getPoint(e,t=new Se){let n=t,s=Math.PI*2,r=this.aEndAngle-this.aStartAngle,o=Math.abs(r)<Number.EPSILON;for(;r<0;)r+=s;for(;r>s;)r-=s;r<Number.EPSILON&&(o?r=0:r=s),this.aClockwise===!0&&!o&&(r===s?r=-s:r=r-s);let a=this.aStartAngle+e*r,l=this.aX+this.xRadius*Math.cos(a),c=this.aY+this.yRadius*Math.sin(a);if(this.aRotation!==0){let h=Math.cos(this.aRotation),u=Math.sin(this.aRotation),d=l-this.aX,f=c-this.aY;l=d*h-f*u+this.aX,c=d*u+f*h+this.aY}return n.set(l,c)}copy(e){return super.copy(e),this.aX=e.aX,this.aY=e.aY,this.xRadius=e.xRadius,this.yRadius=e.yRadius,this.aStartAngle=e.aStartAngle,this.aEndAngle=e.aEndAngle,this.aClockwise=e.aClockwise,this.aRotation=e.aRotation,this}toJSON(){let e=super.toJSON();return e.aX=this.aX,e.aY=this.aY,e.xRadius=this.xRadius,e.yRadius=this.yRadius,e.aStartAngle=this.aStartAngle,e.aEndAngle=this.aEndAngle,e.aClockwise=this.aClockwise,e.aRotation=this.aRotation,e}fromJSON(e){return super.fromJSON(e),this.aX=e.aX,this.aY=e.aY,this.xRadius=e.xRadius,this.yRadius=e.yRadius,this.aStartAngle=e.aStartAngle,this.aEndAngle=e.aEndAngle,this.aClockwise=e.aClockwise,this.aRotation=e.aRotation,this}},Bh=class extends dl{constructor(e,t,n,s,r,o){super(e,t,n,n,s,r,o),this.isArcCurve=!0,this.type="ArcCurve"}};function Jp(){let i=0,e=0,t=0,n=0;function s(r,o,a,l){i=r,e=a,t=-3*r+3*o-2*a-l,n=2*r-2*o+a+l}return{initCatmullRom:function(r,o,a,l,c){s(o,a,c*(a-r),c*(l-o))},initNonuniformCatmullRom:function(r,o,a,l,c,h,u){let d=(o-r)/c-(a-r)/(c+h)+(a-o)/h,f=(a-o)/h-(l-o)/(h+u)+(l-a)/u;d*=h,f*=h,s(o,a,d,f)},calc:function(r){let o=r*r,a=o*r;return i+e*r+t*o+n*a}}}var Qy=new I,ex=new I,lp=new Jp,cp=new Jp,hp=new Jp,zh=class extends ni{constructor(e=[],t=!1,n="centripetal",s=.5){super(),this.isCatmullRomCurve3=!0,this.type="CatmullRomCurve3",this.points=e,this.closed=t,this.curveType=n,this.tension=s}getPoint(e,t=new I){let n=t,s=this.points,r=s.length,o=(r-(this.closed?0:1))*e,a=Math.floor(o),l=o-a;this.closed?a+=a>0?0:(Math.floor(Math.abs(a)/r)+1)*r:l===0&&a===r-1&&(a=r-2,l=1);let c,h;this.closed||a>0?c=s[(a-1)%r]:(ex.subVectors(s[0],s[1]).add(s[0]),c=ex);let u=s[a%r],d=s[(a+1)%r];if(this.closed||a+2<r?h=s[(a+2)%r]:(Qy.subVectors(s[r-1],s[r-2]).add(s[r-1]),h=Qy),this.curveType==="centripetal"||this.curveType==="chordal"){let f=this.curveType==="chordal"?.5:.25,p=Math.pow(c.distanceToSquared(u),f),_=Math.pow(u.distanceToSquared(d),f),m=Math.pow(d.distanceToSquared(h),f);_<1e-4&&(_=1),p<1e-4&&(p=_),m<1e-4&&(m=_),lp.initNonuniformCatmullRom(c.x,u.x,d.x,h.x,p,_,m),cp.initNonuniformCatmullRom(c.y,u.y,d.y,h.y,p,_,m),hp.initNonuniformCatmullRom(c.z,u.z,d.z,h.z,p,_,m)}else this.curveType==="catmullrom"&&(lp.initCatmullRom(c.x,u.x,d.x,h.x,this.tension),cp.initCatmullRom(c.y,u.y,d.y,h.y,this.tension),hp.initCatmullRom(c.z,u.z,d.z,h.z,this.tension));return n.set(lp.calc(l),cp.calc(l),hp.calc(l)),n}copy(e){super.copy(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(s.clone())}return this.closed=e.closed,this.curveType=e.curveType,this.tension=e.tension,this}toJSON(){let e=super.toJSON();e.points=[];for(let t=0,n=this.points.length;t<n;t++){let s=this.points[t];e.points.push(s.toArray())}return e.closed=this.closed,e.curveType=this.curveType,e.tension=this.tension,e}fromJSON(e){super.fromJSON(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(new I().fromArray(s))}return this.closed=e.closed,this.curveType=e.curveType,this.tension=e.tension,this}};function tx(i,e,t,n,s){let r=(n-e)*.5,o=(s-t)*.5,a=i*i,l=i*a;return(2*t-2*n+r+o)*l+(-3*t+3*n-2*r-o)*a+r*i+t}function lT(i,e){let t=1-i;return t*t*e}function cT(i,e){return 2*(1-i)*i*e}function hT(i,e){return i*i*e}function ja(i,e,t,n){return lT(i,e)+cT(i,t)+hT(i,n)}function uT(i,e){let t=1-i;return t*t*t*e}function dT(i,e){let t=1-i;return 3*t*t*i*e}function fT(i,e){return 3*(1-i)*i*i*e}function pT(i,e){return i*i*i*e}function Za(i,e,t,n,s){return uT(i,e)+dT(i,t)+fT(i,n)+pT(i,s)}var Vh=class extends ni{constructor(e=new Se,t=new Se,n=new Se,s=new Se){super(),this.isCubicBezierCurve=!0,this.type="CubicBezierCurve",this.v0=e,this.v1=t,this.v2=n,this.v3=s}getPoint(e,t=new Se){let n=t,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return n.set(Za(e,s.x,r.x,o.x,a.x),Za(e,s.y,r.y,o.y,a.y)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this.v3.copy(e.v3),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e.v3=this.v3.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this.v3.fromArray(e.v3),this}},Gh=class extends ni{constructor(e=new I,t=new I,n=new I,s=new I){super(),this.isCubicBezierCurve3=!0,this.type="CubicBezierCurve3",this.v0=e,this.v1=t,this.v2=n,this.v3=s}getPoint(e,t=new I){let n=t,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return n.set(Za(e,s.x,r.x,o.x,a.x),Za(e,s.y,r.y,o.y,a.y),Za(e,s.z,r.z,o.z,a.z)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this.v3.copy(e.v3),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e.v3=this.v3.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this.v3.fromArray(e.v3),this}},Hh=class extends ni{constructor(e=new Se,t=new Se){super(),this.isLineCurve=!0,this.type="LineCurve",this.v1=e,this.v2=t}getPoint(e,t=new Se){let n=t;return e===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(e).add(this.v1)),n}getPointAt(e,t){return this.getPoint(e,t)}getTangent(e,t=new Se){return t.subVectors(this.v2,this.v1).normalize()}getTangentAt(e,t){return this.getTangent(e,t)}copy(e){return super.copy(e),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},Wh=class extends ni{constructor(e=new I,t=new I){super(),this.isLineCurve3=!0,this.type="LineCurve3",this.v1=e,this.v2=t}getPoint(e,t=new I){let n=t;return e===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(e).add(this.v1)),n}getPointAt(e,t){return this.getPoint(e,t)}getTangent(e,t=new I){return t.subVectors(this.v2,this.v1).normalize()}getTangentAt(e,t){return this.getTangent(e,t)}copy(e){return super.copy(e),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},$h=class extends ni{constructor(e=new Se,t=new Se,n=new Se){super(),this.isQuadraticBezierCurve=!0,this.type="QuadraticBezierCurve",this.v0=e,this.v1=t,this.v2=n}getPoint(e,t=new Se){let n=t,s=this.v0,r=this.v1,o=this.v2;return n.set(ja(e,s.x,r.x,o.x),ja(e,s.y,r.y,o.y)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},fl=class extends ni{constructor(e=new I,t=new I,n=new I){super(),this.isQuadraticBezierCurve3=!0,this.type="QuadraticBezierCurve3",this.v0=e,this.v1=t,this.v2=n}getPoint(e,t=new I){let n=t,s=this.v0,r=this.v1,o=this.v2;return n.set(ja(e,s.x,r.x,o.x),ja(e,s.y,r.y,o.y),ja(e,s.z,r.z,o.z)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},qh=class extends ni{constructor(e=[]){super(),this.isSplineCurve=!0,this.type="SplineCurve",this.points=e}getPoint(e,t=new Se){let n=t,s=this.points,r=(s.length-1)*e,o=Math.floor(r),a=r-o,l=s[o===0?o:o-1],c=s[o],h=s[o>s.length-2?s.length-1:o+1],u=s[o>s.length-3?s.length-1:o+2];return n.set(tx(a,l.x,c.x,h.x,u.x),tx(a,l.y,c.y,h.y,u.y)),n}copy(e){super.copy(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(s.clone())}return this}toJSON(){let e=super.toJSON();e.points=[];for(let t=0,n=this.points.length;t<n;t++){let s=this.points[t];e.points.push(s.toArray())}return e}fromJSON(e){super.fromJSON(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(new Se().fromArray(s))}return this}},mT=Object.freeze({__proto__:null,ArcCurve:Bh,CatmullRomCurve3:zh,CubicBezierCurve:Vh,CubicBezierCurve3:Gh,EllipseCurve:dl,LineCurve:Hh,LineCurve3:Wh,QuadraticBezierCurve:$h,QuadraticBezierCurve3:fl,SplineCurve:qh});var pl=class i extends Nt{constructor(e=[new Se(0,-.5),new Se(.5,0),new Se(0,.5)],t=12,n=0,s=Math.PI*2){super(),this.type="LatheGeometry",this.parameters={points:e,segments:t,phiStart:n,phiLength:s},t=Math.floor(t),s=ht(s,0,Math.PI*2);let r=[],o=[],a=[],l=[],c=[],h=1/t,u=new I,d=new Se,f=new I,p=new I,_=new I,m=0,g=0;for(let x=0;x<=e.length-1;x++)switch(x){case 0:m=e[x+1].x-e[x].x,g=e[x+1].y-e[x].y,f.x=g*1,f.y=-m,f.z=g*0,_.copy(f),f.normalize(),l.push(f.x,f.y,f.z);break;case e.length-1:_.normalize(),l.push(_.x,_.y,_.z);break;default:m=e[x+1].x-e[x].x,g=e[x+1].y-e[x].y,f.x=g*1,f.y=-m,f.z=g*0,p.copy(f),f.x+=_.x,f.y+=_.y,f.z+=_.z,f.normalize(),l.push(f.x,f.y,f.z),_.copy(p)}for(let x=0;x<=t;x++){let C=n+x*h*s,b=Math.sin(C),A=Math.cos(C);for(let S=0;S<=e.length-1;S++){u.x=e[S].x*b,u.y=e[S].y,u.z=e[S].x*A,o.push(u.x,u.y,u.z),d.x=x/t,d.y=S/(e.length-1),a.push(d.x,d.y);let y=l[3*S+0]*b,M=l[3*S+1],U=l[3*S+0]*A;c.push(y,M,U)}}for(let x=0;x<t;x++)for(let C=0;C<e.length-1;C++){let b=C+x*e.length,A=b,S=b+e.length,y=b+e.length+1,M=b+1;r.push(A,S,M),r.push(y,M,S)}this.setIndex(r),this.setAttribute("position",new ut(o,3)),this.setAttribute("uv",new ut(a,2)),this.setAttribute("normal",new ut(c,3))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.points,e.segments,e.phiStart,e.phiLength)}};var ml=class i extends Nt{constructor(e=1,t=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(n),l=Math.floor(s),c=a+1,h=l+1,u=e/a,d=t/l,f=[],p=[],_=[],m=[];for(let g=0;g<h;g++){let x=g*d-o;for(let C=0;C<c;C++){let b=C*u-r;p.push(b,-x,0),_.push(0,0,1),m.push(C/a),m.push(1-g/l)}}for(let g=0;g<l;g++)for(let x=0;x<a;x++){let C=x+c*g,b=x+c*(g+1),A=x+1+c*(g+1),S=x+1+c*g;f.push(C,b,S),f.push(b,A,S)}this.setIndex(f),this.setAttribute("position",new ut(p,3)),this.setAttribute("normal",new ut(_,3)),this.setAttribute("uv",new ut(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.widthSegments,e.heightSegments)}},gl=class i extends Nt{constructor(e=.5,t=1,n=32,s=1,r=0,o=Math.PI*2){super(),this.type="RingGeometry",this.parameters={innerRadius:e,outerRadius:t,thetaSegments:n,phiSegments:s,thetaStart:r,thetaLength:o},n=Math.max(3,n),s=Math.max(1,s);let a=[],l=[],c=[],h=[],u=e,d=(t-e)/s,f=new I,p=new Se;for(let _=0;_<=s;_++){for(let m=0;m<=n;m++){let g=r+m/n*o;f.x=u*Math.cos(g),f.y=u*Math.sin(g),l.push(f.x,f.y,f.z),c.push(0,0,1),p.x=(f.x/t+1)/2,p.y=(f.y/t+1)/2,h.push(p.x,p.y)}u+=d}for(let _=0;_<s;_++){let m=_*(n+1);for(let g=0;g<n;g++){let x=g+m,C=x,b=x+n+1,A=x+n+2,S=x+1;a.push(C,b,S),a.push(b,A,S)}}this.setIndex(a),this.setAttribute("position",new ut(l,3)),this.setAttribute("normal",new ut(c,3)),this.setAttribute("uv",new ut(h,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.innerRadius,e.outerRadius,e.thetaSegments,e.phiSegments,e.thetaStart,e.thetaLength)}};var _l=class i extends Nt{constructor(e=1,t=32,n=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:n,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),n=Math.max(2,Math.floor(n));let l=Math.min(o+a,Math.PI),c=0,h=[],u=new I,d=new I,f=[],p=[],_=[],m=[];for(let g=0;g<=n;g++){let x=[],C=g/n,b=o+C*a,A=e*Math.cos(b),S=Math.sqrt(e*e-A*A),y=0;g===0&&o===0?y=.5/t:g===n&&l===Math.PI&&(y=-.5/t);for(let M=0;M<=t;M++){let U=M/t,N=s+U*r;u.x=-S*Math.cos(N),u.y=A,u.z=S*Math.sin(N),p.push(u.x,u.y,u.z),d.copy(u).normalize(),_.push(d.x,d.y,d.z),m.push(U+y,1-C),x.push(c++)}h.push(x)}for(let g=0;g<n;g++)for(let x=0;x<t;x++){let C=h[g][x+1],b=h[g][x],A=h[g+1][x],S=h[g+1][x+1];(g!==0||o>0)&&f.push(C,b,S),(g!==n-1||l<Math.PI)&&f.push(b,A,S)}this.setIndex(f),this.setAttribute("position",new ut(p,3)),this.setAttribute("normal",new ut(_,3)),this.setAttribute("uv",new ut(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};var yl=class i extends Nt{constructor(e=1,t=.4,n=12,s=48,r=Math.PI*2,o=0,a=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:e,tube:t,radialSegments:n,tubularSegments:s,arc:r,thetaStart:o,thetaLength:a},n=Math.floor(n),s=Math.floor(s);let l=[],c=[],h=[],u=[],d=new I,f=new I,p=new I;for(let _=0;_<=n;_++){let m=o+_/n*a;for(let g=0;g<=s;g++){let x=g/s*r;f.x=(e+t*Math.cos(m))*Math.cos(x),f.y=(e+t*Math.cos(m))*Math.sin(x),f.z=t*Math.sin(m),c.push(f.x,f.y,f.z),d.x=e*Math.cos(x),d.y=e*Math.sin(x),p.subVectors(f,d).normalize(),h.push(p.x,p.y,p.z),u.push(g/s),u.push(_/n)}}for(let _=1;_<=n;_++)for(let m=1;m<=s;m++){let g=(s+1)*_+m-1,x=(s+1)*(_-1)+m-1,C=(s+1)*(_-1)+m,b=(s+1)*_+m;l.push(g,x,b),l.push(x,C,b)}this.setIndex(l),this.setAttribute("position",new ut(c,3)),this.setAttribute("normal",new ut(h,3)),this.setAttribute("uv",new ut(u,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.tube,e.radialSegments,e.tubularSegments,e.arc,e.thetaStart,e.thetaLength)}};var xl=class i extends Nt{constructor(e=new fl(new I(-1,-1,0),new I(-1,1,0),new I(1,1,0)),t=64,n=1,s=8,r=!1){super(),this.type="TubeGeometry",this.parameters={path:e,tubularSegments:t,radius:n,radialSegments:s,closed:r};let o=e.computeFrenetFrames(t,r);this.tangents=o.tangents,this.normals=o.normals,this.binormals=o.binormals;let a=new I,l=new I,c=new Se,h=new I,u=[],d=[],f=[],p=[];_(),this.setIndex(p),this.setAttribute("position",new ut(u,3)),this.setAttribute("normal",new ut(d,3)),this.setAttribute("uv",new ut(f,2));function _(){for(let C=0;C<t;C++)m(C);m(r===!1?t:0),x(),g()}function m(C){h=e.getPointAt(C/t,h);let b=o.normals[C],A=o.binormals[C];for(let S=0;S<=s;S++){let y=S/s*Math.PI*2,M=Math.sin(y),U=-Math.cos(y);l.x=U*b.x+M*A.x,l.y=U*b.y+M*A.y,l.z=U*b.z+M*A.z,l.normalize(),d.push(l.x,l.y,l.z),a.x=h.x+n*l.x,a.y=h.y+n*l.y,a.z=h.z+n*l.z,u.push(a.x,a.y,a.z)}}function g(){for(let C=1;C<=t;C++)for(let b=1;b<=s;b++){let A=(s+1)*(C-1)+(b-1),S=(s+1)*C+(b-1),y=(s+1)*C+b,M=(s+1)*(C-1)+b;p.push(A,S,M),p.push(S,y,M)}}function x(){for(let C=0;C<=t;C++)for(let b=0;b<=s;b++)c.x=C/t,c.y=b/s,f.push(c.x,c.y)}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}toJSON(){let e=super.toJSON();return e.path=this.parameters.path.toJSON(),e}static fromJSON(e){return new i(new mT[e.path.type]().fromJSON(e.path),e.tubularSegments,e.radius,e.radialSegments,e.closed)}};function Gr(i){let e={};for(let t in i){e[t]={};for(let n in i[t]){let s=i[t][n];if(nx(s))s.isRenderTargetTexture?(Ze("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=s.clone();else if(Array.isArray(s))if(nx(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][n]=r}else e[t][n]=s.slice();else e[t][n]=s}}return e}function Vn(i){let e={};for(let t=0;t<i.length;t++){let n=Gr(i[t]);for(let s in n)e[s]=n[s]}return e}function nx(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function gT(i){let e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}function Qp(i){let e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:St.workingColorSpace}var Zx={clone:Gr,merge:Vn},_T=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,yT=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,cs=class extends ls{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=_T,this.fragmentShader=yT,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Gr(e.uniforms),this.uniformsGroups=gT(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let n in e.uniforms){let s=e.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=t[s.value]||null;break;case"c":this.uniforms[n].value=new ot().setHex(s.value);break;case"v2":this.uniforms[n].value=new Se().fromArray(s.value);break;case"v3":this.uniforms[n].value=new I().fromArray(s.value);break;case"v4":this.uniforms[n].value=new Jt().fromArray(s.value);break;case"m3":this.uniforms[n].value=new it().fromArray(s.value);break;case"m4":this.uniforms[n].value=new yt().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let n in e.extensions)this.extensions[n]=e.extensions[n];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},Xh=class extends cs{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Ri=class extends ls{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new ot(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new ot(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Xu,this.normalScale=new Se(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Is,this.combine=Qo,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},Yh=class extends ls{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Ux,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},jh=class extends ls{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function Do(i,e){return!i||i.constructor===e?i:typeof e.BYTES_PER_ELEMENT=="number"?new e(i):Array.prototype.slice.call(i)}function mh(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var or=class{constructor(e,t,n,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(n),this.sampleValues=t,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,n=this._cachedIndex,s=t[n],r=t[n-1];n:{e:{let o;t:{i:if(!(e<s)){for(let a=n+2;;){if(s===void 0){if(e<r)break i;return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=t[++n],e<s)break e}o=t.length;break t}if(!(e>=r)){let a=t[1];e<a&&(n=2,r=a);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=t[--n-1],e>=r)break e}o=n,n=0;break t}break n}for(;n<o;){let a=n+o>>>1;e<t[a]?o=a:n=a+1}if(s=t[n],r=t[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=n[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Zh=class extends or{constructor(e,t,n,s){super(e,t,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:pp,endingEnd:pp}}intervalChanged_(e,t,n){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case mp:r=e,a=2*t-n;break;case gp:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case mp:o=e,l=2*n-t;break;case gp:o=1,l=n+s[1]-s[0];break;default:o=e-1,l=t}let c=(n-t)*.5,h=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-n),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=this._offsetPrev,u=this._offsetNext,d=this._weightPrev,f=this._weightNext,p=(n-t)/(s-t),_=p*p,m=_*p,g=-d*m+2*d*_-d*p,x=(1+d)*m+(-1.5-2*d)*_+(-.5+d)*p+1,C=(-1-f)*m+(1.5+f)*_+.5*p,b=f*m-f*_;for(let A=0;A!==a;++A)r[A]=g*o[h+A]+x*o[c+A]+C*o[l+A]+b*o[u+A];return r}},Kh=class extends or{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=(n-t)/(s-t),u=1-h;for(let d=0;d!==a;++d)r[d]=o[c+d]*u+o[l+d]*h;return r}},Jh=class extends or{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e){return this.copySampleValue_(e-1)}},Qh=class extends or{interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=this.inTangents,u=this.outTangents;if(!h||!u){let p=(n-t)/(s-t),_=1-p;for(let m=0;m!==a;++m)r[m]=o[c+m]*_+o[l+m]*p;return r}let d=a*2,f=e-1;for(let p=0;p!==a;++p){let _=o[c+p],m=o[l+p],g=f*d+p*2,x=u[g],C=u[g+1],b=e*d+p*2,A=h[b],S=h[b+1],y=vT(n,t,x,A,s);r[p]=Kx(y,_,C,S,m)}return r}};function Kx(i,e,t,n,s){let r=1-i;return r*r*r*e+3*r*r*i*t+3*r*i*i*n+i*i*i*s}function xT(i,e,t,n,s){let r=1-i;return 3*r*r*(t-e)+6*r*i*(n-t)+3*i*i*(s-n)}function vT(i,e,t,n,s){let r=(i-e)/(s-e);for(let o=0;o<8;o++){let a=Kx(r,e,t,n,s)-i;if(Math.abs(a)<1e-10)break;let l=xT(r,e,t,n,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var bi=class{constructor(e,t,n,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=Do(t,this.TimeBufferType),this.values=Do(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,n;if(t.toJSON!==this.toJSON)n=t.toJSON(e);else{n={name:e.name,times:Do(e.times,Array),values:Do(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(n.interpolation=s),mh(e.settings)&&(n.settings={inTangents:Do(e.settings.inTangents,Array),outTangents:Do(e.settings.outTangents,Array)})}return n.type=e.ValueTypeName,n}InterpolantFactoryMethodDiscrete(e){return new Jh(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new Kh(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new Zh(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new Qh(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case Ka:t=this.InterpolantFactoryMethodDiscrete;break;case Ph:t=this.InterpolantFactoryMethodLinear;break;case xh:t=this.InterpolantFactoryMethodSmooth;break;case fp:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return Ze("KeyframeTrack:",n),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Ka;case this.InterpolantFactoryMethodLinear:return Ph;case this.InterpolantFactoryMethodSmooth:return xh;case this.InterpolantFactoryMethodBezier:return fp}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]+=e;mh(this.settings)&&(ix(this.settings.inTangents,e),ix(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]*=e;mh(this.settings)&&(sx(this.settings.inTangents,e),sx(this.settings.outTangents,e))}return this}trim(e,t){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<e;)++r;for(;o!==-1&&n[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(Qe("KeyframeTrack: Invalid value size in track.",this),e=!1);let n=this.times,s=this.values,r=n.length;r===0&&(Qe("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){Qe("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){Qe("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&CE(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){Qe("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===xh,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],h=e[a+1];if(c!==h&&(a!==1||c!==e[0]))if(s)l=!0;else{let u=a*n,d=u-n,f=u+n;for(let p=0;p!==n;++p){let _=t[u+p];if(_!==t[d+p]||_!==t[f+p]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let u=a*n,d=o*n;for(let f=0;f!==n;++f)t[d+f]=t[u+f]}++o}}if(r>0){e[o]=e[r];for(let a=r*n,l=o*n,c=0;c!==n;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*n)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),n=this.constructor,s=new n(this.name,e,t);return s.createInterpolant=this.createInterpolant,mh(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function ix(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]+=e}function sx(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]*=e}bi.prototype.ValueTypeName="";bi.prototype.TimeBufferType=Float32Array;bi.prototype.ValueBufferType=Float32Array;bi.prototype.DefaultInterpolation=Ph;var ar=class extends bi{constructor(e,t,n){super(e,t,n)}};ar.prototype.ValueTypeName="bool";ar.prototype.ValueBufferType=Array;ar.prototype.DefaultInterpolation=Ka;ar.prototype.InterpolantFactoryMethodLinear=void 0;ar.prototype.InterpolantFactoryMethodSmooth=void 0;var eu=class extends bi{constructor(e,t,n,s){super(e,t,n,s)}};eu.prototype.ValueTypeName="color";var tu=class extends bi{constructor(e,t,n,s){super(e,t,n,s)}};tu.prototype.ValueTypeName="number";var nu=class extends or{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-t)/(s-t),c=e*a;for(let h=c+a;c!==h;c+=4)Mn.slerpFlat(r,0,o,c-a,o,c,l);return r}},vl=class extends bi{constructor(e,t,n,s){super(e,t,n,s)}InterpolantFactoryMethodLinear(e){return new nu(this.times,this.values,this.getValueSize(),e)}};vl.prototype.ValueTypeName="quaternion";vl.prototype.InterpolantFactoryMethodSmooth=void 0;var lr=class extends bi{constructor(e,t,n){super(e,t,n)}};lr.prototype.ValueTypeName="string";lr.prototype.ValueBufferType=Array;lr.prototype.DefaultInterpolation=Ka;lr.prototype.InterpolantFactoryMethodLinear=void 0;lr.prototype.InterpolantFactoryMethodSmooth=void 0;var iu=class extends bi{constructor(e,t,n,s){super(e,t,n,s)}};iu.prototype.ValueTypeName="vector";var su=class{constructor(e,t,n){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=n,this._abortController=null,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,u){return c.push(h,u),this},this.removeHandler=function(h){let u=c.indexOf(h);return u!==-1&&c.splice(u,2),this},this.getHandler=function(h){for(let u=0,d=c.length;u<d;u+=2){let f=c[u],p=c[u+1];if(f.global&&(f.lastIndex=0),f.test(h))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},Jx=new su,ru=class{constructor(e){this.manager=e!==void 0?e:Jx,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let n=this;return new Promise(function(s,r){n.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};ru.DEFAULT_MATERIAL_NAME="__DEFAULT";var bl=class extends wn{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new ot(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}},Yo=class extends bl{constructor(e,t,n){super(e,n),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(wn.DEFAULT_UP),this.updateMatrix(),this.groundColor=new ot(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}toJSON(e){let t=super.toJSON(e);return t.object.groundColor=this.groundColor.getHex(),t}},up=new yt,rx=new I,ox=new I,ou=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Se(512,512),this.mapType=ii,this.map=null,this.mapPass=null,this.matrix=new yt,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new sr,this._frameExtents=new Se(1,1),this._viewportCount=1,this._viewports=[new Jt(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;rx.setFromMatrixPosition(e.matrixWorld),t.position.copy(rx),ox.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(ox),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,n,s){up.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),n.setFromProjectionMatrix(up,e.coordinateSystem,e.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;e.coordinateSystem===Bo||e.reversedDepth?t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),t.multiply(up)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},gh=new I,_h=new Mn,rs=new I,Sl=class extends wn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new yt,this.projectionMatrix=new yt,this.projectionMatrixInverse=new yt,this.coordinateSystem=Ai,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(gh,_h,rs),rs.x===1&&rs.y===1&&rs.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(gh,_h,rs.set(1,1,1)).invert()}updateWorldMatrix(e,t,n=!1){super.updateWorldMatrix(e,t,n),this.matrixWorld.decompose(gh,_h,rs),rs.x===1&&rs.y===1&&rs.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(gh,_h,rs.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},nr=new I,ax=new Se,lx=new Se,Zn=class extends Sl{constructor(e=50,t=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=Vo*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(Uo*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Vo*2*Math.atan(Math.tan(Uo*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){nr.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(nr.x,nr.y).multiplyScalar(-e/nr.z),nr.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(nr.x,nr.y).multiplyScalar(-e/nr.z)}getViewSize(e,t){return this.getViewBounds(e,ax,lx),t.subVectors(lx,ax)}setViewOffset(e,t,n,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(Uo*.5*this.fov)/this.zoom,n=2*t,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-n,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var kr=class extends Sl{constructor(e=-1,t=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-e,o=n+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},_p=class extends ou{constructor(){super(new kr(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},jo=class extends bl{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(wn.DEFAULT_UP),this.updateMatrix(),this.target=new wn,this.shadow=new _p}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}};var No=-90,Oo=1,Zo=class extends wn{constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Zn(No,Oo,e,t);s.layers=this.layers,this.add(s);let r=new Zn(No,Oo,e,t);r.layers=this.layers,this.add(r);let o=new Zn(No,Oo,e,t);o.layers=this.layers,this.add(o);let a=new Zn(No,Oo,e,t);a.layers=this.layers,this.add(a);let l=new Zn(No,Oo,e,t);l.layers=this.layers,this.add(l);let c=new Zn(No,Oo,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[n,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===Ai)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===Bo)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,h]=this.children,u=e.getRenderTarget(),d=e.getActiveCubeFace(),f=e.getActiveMipmapLevel(),p=e.xr.enabled;e.xr.enabled=!1;let _=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let m=!1;e.isWebGLRenderer===!0?m=e.state.buffers.depth.getReversed():m=e.reversedDepthBuffer,e.setRenderTarget(n,0,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(n,1,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(n,2,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(n,3,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(n,4,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),n.texture.mipmapsAutoUpdate=_,e.setRenderTarget(n,5,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,h),e.setRenderTarget(u,d,f),e.xr.enabled=p,n.texture.needsPMREMUpdate=!0}},au=class extends Zn{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var em="\\[\\]\\.:\\/",bT=new RegExp("["+em+"]","g"),tm="[^"+em+"]",ST="[^"+em.replace("\\.","")+"]",MT=/((?:WC+[\/:])*)/.source.replace("WC",tm),wT=/(WCOD+)?/.source.replace("WCOD",ST),ET=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",tm),TT=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",tm),AT=new RegExp("^"+MT+wT+ET+TT+"$"),CT=["material","materials","bones","map"],yp=class{constructor(e,t,n){let s=n||jt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(e,t)}setValue(e,t){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].unbind()}},jt=class i{constructor(e,t,n){this.path=t,this.parsedPath=n||i.parseTrackName(t),this.node=i.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,n){return e&&e.isAnimationObjectGroup?new i.Composite(e,t,n):new i(e,t,n)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(bT,"")}static parseTrackName(e){let t=AT.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let n={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);CT.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return n}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let n=e.skeleton.getBoneByName(t);if(n!==void 0)return n}if(e.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=n(a.children);if(l)return l}return null},s=n(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)e[t++]=n[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,n=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=i.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Ze("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=t.objectIndex;switch(n){case"materials":if(!e.material){Qe("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){Qe("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){Qe("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let h=0;h<e.length;h++)if(e[h].name===c){c=h;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){Qe("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){Qe("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[n]===void 0){Qe("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[n]}if(c!==void 0){if(e[c]===void 0){Qe("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;Qe("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){Qe("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){Qe("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};jt.Composite=yp;jt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};jt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};jt.prototype.GetterByBindingType=[jt.prototype._getValue_direct,jt.prototype._getValue_array,jt.prototype._getValue_arrayElement,jt.prototype._getValue_toArray];jt.prototype.SetterByBindingTypeAndVersioning=[[jt.prototype._setValue_direct,jt.prototype._setValue_direct_setNeedsUpdate,jt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[jt.prototype._setValue_array,jt.prototype._setValue_array_setNeedsUpdate,jt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[jt.prototype._setValue_arrayElement,jt.prototype._setValue_arrayElement_setNeedsUpdate,jt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[jt.prototype._setValue_fromArray,jt.prototype._setValue_fromArray_setNeedsUpdate,jt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var $2=new Float32Array(1);var cx=new yt,Ml=class{constructor(e,t,n=0,s=1/0){this.ray=new ir(e,t),this.near=n,this.far=s,this.camera=null,this.layers=new Ho,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(e,t){this.ray.set(e,t)}setFromCamera(e,t){t.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(e.x,e.y,.5).unproject(t).sub(this.ray.origin).normalize(),this.camera=t):t.isOrthographicCamera?(this.ray.origin.set(e.x,e.y,t.projectionMatrix.elements[14]).unproject(t),this.ray.direction.set(0,0,-1).transformDirection(t.matrixWorld),this.camera=t):Qe("Raycaster: Unsupported camera type: "+t.type)}setFromXRController(e){return cx.identity().extractRotation(e.matrixWorld),this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(cx),this}intersectObject(e,t=!0,n=[]){return xp(e,this,n,t),n.sort(hx),n}intersectObjects(e,t=!0,n=[]){for(let s=0,r=e.length;s<r;s++)xp(e[s],this,n,t);return n.sort(hx),n}};function hx(i,e){return i.distance-e.distance}function xp(i,e,t,n){let s=!0;if(i.layers.test(e.layers)&&i.raycast(e,t)===!1&&(s=!1),s===!0&&n===!0){let r=i.children;for(let o=0,a=r.length;o<a;o++)xp(r[o],e,t,!0)}}var Ko=class{constructor(e=1,t=0,n=0){this.radius=e,this.phi=t,this.theta=n}set(e,t,n){return this.radius=e,this.phi=t,this.theta=n,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=ht(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,n){return this.radius=Math.sqrt(e*e+t*t+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,n),this.phi=Math.acos(ht(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var vp=class{static{this.prototype.isMatrix2=!0}constructor(e,t,n,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let n=0;n<4;n++)this.elements[n]=e[n+t];return this}set(e,t,n,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=n,r[3]=s,this}};var wl=class extends vi{constructor(e=10,t=10,n=4473924,s=8947848){n=new ot(n),s=new ot(s);let r=t/2,o=e/t,a=e/2,l=[],c=[];for(let d=0,f=0,p=-a;d<=t;d++,p+=o){l.push(-a,0,p,a,0,p),l.push(p,0,-a,p,0,a);let _=d===r?n:s;_.toArray(c,f),f+=3,_.toArray(c,f),f+=3,_.toArray(c,f),f+=3,_.toArray(c,f),f+=3}let h=new Nt;h.setAttribute("position",new ut(l,3)),h.setAttribute("color",new ut(c,3));let u=new en({vertexColors:!0,toneMapped:!1});super(h,u),this.type="GridHelper"}dispose(){super.dispose(),this.geometry.dispose(),this.material.dispose()}};var ux=new I,yh,dp,Ns=class extends wn{constructor(e=new I(0,0,1),t=new I(0,0,0),n=1,s=16776960,r=n*.2,o=r*.2){super(),this.type="ArrowHelper",yh===void 0&&(yh=new Nt,yh.setAttribute("position",new ut([0,0,0,0,1,0],3)),dp=new Xo(.5,1,5,1),dp.translate(0,-.5,0)),this.position.copy(t),this.line=new Ci(yh,new en({color:s,toneMapped:!1})),this.line.matrixAutoUpdate=!1,this.add(this.line),this.cone=new Mt(dp,new Hi({color:s,toneMapped:!1})),this.cone.matrixAutoUpdate=!1,this.add(this.cone),this.setDirection(e),this.setLength(n,r,o)}setDirection(e){if(e.y>.99999)this.quaternion.set(0,0,0,1);else if(e.y<-.99999)this.quaternion.set(1,0,0,0);else{ux.set(e.z,0,-e.x).normalize();let t=Math.acos(e.y);this.quaternion.setFromAxisAngle(ux,t)}}setLength(e,t=e*.2,n=t*.2){this.line.scale.set(1,Math.max(1e-4,e-t),1),this.line.updateMatrix(),this.cone.scale.set(n,t,n),this.cone.position.y=e,this.cone.updateMatrix()}setColor(e){this.line.material.color.set(e),this.cone.material.color.set(e)}copy(e){return super.copy(e,!1),this.line.copy(e.line),this.cone.copy(e.cone),this}dispose(){super.dispose(),this.line.geometry.dispose(),this.line.material.dispose(),this.cone.geometry.dispose(),this.cone.material.dispose()}};var El=class extends Gi{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function nm(i,e,t,n){let s=RT(n);switch(t){case Bp:return i*e;case Vp:return i*e/s.components*s.byteLength;case pu:return i*e/s.components*s.byteLength;case fr:return i*e*2/s.components*s.byteLength;case mu:return i*e*2/s.components*s.byteLength;case zp:return i*e*3/s.components*s.byteLength;case Yi:return i*e*4/s.components*s.byteLength;case gu:return i*e*4/s.components*s.byteLength;case Cl:case Rl:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Pl:case Il:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case yu:case vu:return Math.max(i,16)*Math.max(e,8)/4;case _u:case xu:return Math.max(i,8)*Math.max(e,8)/2;case bu:case Su:case wu:case Eu:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Mu:case Ll:case Tu:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Au:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Cu:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case Ru:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case Pu:return Math.floor((i+5)/6)*Math.floor((e+4)/5)*16;case Iu:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case Lu:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case Du:return Math.floor((i+7)/8)*Math.floor((e+5)/6)*16;case Nu:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case Ou:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case Uu:return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case Fu:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case ku:return Math.floor((i+9)/10)*Math.floor((e+9)/10)*16;case Bu:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case zu:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case Vu:case Gu:case Hu:return Math.ceil(i/4)*Math.ceil(e/4)*16;case Wu:case $u:return Math.ceil(i/4)*Math.ceil(e/4)*8;case Dl:case qu:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function RT(i){switch(i){case ii:case Op:return{byteLength:1,components:1};case ta:case Up:case Xi:return{byteLength:2,components:1};case du:case fu:return{byteLength:2,components:4};case $i:case uu:case qi:return{byteLength:4,components:1};case Fp:case kp:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Ze("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function vv(){let i=null,e=!1,t=null,n=null;function s(r,o){n=i.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&i!==null&&(n=i.requestAnimationFrame(s),e=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){i=r}}}function IT(i){let e=new WeakMap;function t(a,l){let c=a.array,h=a.usage,u=c.byteLength,d=i.createBuffer();i.bindBuffer(l,d),i.bufferData(l,c,h),a.onUploadCallback();let f;if(c instanceof Float32Array)f=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=i.HALF_FLOAT:f=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=i.SHORT;else if(c instanceof Uint32Array)f=i.UNSIGNED_INT;else if(c instanceof Int32Array)f=i.INT;else if(c instanceof Int8Array)f=i.BYTE;else if(c instanceof Uint8Array)f=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:u}}function n(a,l,c){let h=l.array,u=l.updateRanges;if(i.bindBuffer(c,a),u.length===0)i.bufferSubData(c,0,h);else{u.sort((f,p)=>f.start-p.start);let d=0;for(let f=1;f<u.length;f++){let p=u[d],_=u[f];_.start<=p.start+p.count+1?p.count=Math.max(p.count,_.start+_.count-p.start):(++d,u[d]=_)}u.length=d+1;for(let f=0,p=u.length;f<p;f++){let _=u[f];i.bufferSubData(c,_.start*h.BYTES_PER_ELEMENT,h,_.start,_.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(i.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=e.get(a);(!h||h.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var LT=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,DT=`#ifdef USE_ALPHAHASH
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
#endif`,NT=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,OT=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,UT=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,FT=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,kT=`#ifdef USE_AOMAP
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
#endif`,BT=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,zT=`#ifdef USE_BATCHING
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
#endif`,VT=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,GT=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,HT=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,WT=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,$T=`#ifdef USE_IRIDESCENCE
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
#endif`,qT=`#ifdef USE_BUMPMAP
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
#endif`,XT=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,YT=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,jT=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,ZT=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,KT=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,JT=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,QT=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,e1=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,t1=`#define PI 3.141592653589793
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
} // validated`,n1=`vec3 transformedNormal = objectNormal;
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
#endif`,i1=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,s1=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,r1=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,o1=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,a1="gl_FragColor = linearToOutputTexel( gl_FragColor );",l1=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,c1=`#ifdef USE_ENVMAP
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
#endif`,h1=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,u1=`#ifdef USE_ENVMAP
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
#endif`,d1=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,f1=`#ifdef USE_ENVMAP
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
#endif`,p1=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,m1=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,g1=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,_1=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,y1=`#ifdef USE_GRADIENTMAP
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
}`,x1=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,v1=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,b1=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,S1=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,M1=`#ifdef USE_ENVMAP
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
#endif`,w1=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,E1=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,T1=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,A1=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,C1=`PhysicalMaterial material;
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
#endif`,R1=`uniform sampler2D dfgLUT;
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
}`,P1=`
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
#endif`,I1=`#if defined( RE_IndirectDiffuse )
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
#endif`,L1=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,D1=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,N1=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,O1=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,U1=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,F1=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,k1=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,B1=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,z1=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,V1=`#if defined( USE_POINTS_UV )
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
#endif`,G1=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,H1=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,W1=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,$1=`#if defined( USE_MORPHCOLORS )
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
#endif`,q1=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,X1=`#ifdef USE_MORPHTARGETS
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
#endif`,Y1=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,j1=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,Z1=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,K1=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,J1=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Q1=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,eA=`#ifdef USE_NORMALMAP
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
#endif`,tA=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,nA=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,iA=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,sA=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,rA=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,oA=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,aA=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,lA=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,cA=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,hA=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,uA=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,dA=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,fA=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,pA=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,mA=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,gA=`float getShadowMask() {
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
}`,_A=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,yA=`#ifdef USE_SKINNING
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
#endif`,xA=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,vA=`#ifdef USE_SKINNING
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
#endif`,bA=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,SA=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,MA=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,wA=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,EA=`#ifdef USE_TRANSMISSION
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
#endif`,TA=`#ifdef USE_TRANSMISSION
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
#endif`,AA=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,CA=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,RA=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,PA=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,IA=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,LA=`uniform sampler2D t2D;
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
}`,DA=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,NA=`uniform float backgroundBlurriness;
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
}`,OA=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,UA=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,FA=`#include <common>
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
}`,kA=`#if DEPTH_PACKING == 3200
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
}`,BA=`#define DISTANCE
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
}`,zA=`#define DISTANCE
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
}`,VA=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,GA=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,HA=`uniform float scale;
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
}`,WA=`uniform vec3 diffuse;
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
}`,$A=`#include <common>
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
}`,qA=`uniform vec3 diffuse;
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
}`,XA=`#define LAMBERT
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
}`,YA=`#define LAMBERT
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
}`,jA=`#define MATCAP
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
}`,ZA=`#define MATCAP
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
}`,KA=`#define NORMAL
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
}`,JA=`#define NORMAL
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
}`,QA=`#define PHONG
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
}`,eC=`#define PHONG
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
}`,tC=`#define STANDARD
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
}`,nC=`#define STANDARD
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
}`,iC=`#define TOON
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
}`,sC=`#define TOON
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
}`,rC=`uniform float size;
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
}`,oC=`uniform vec3 diffuse;
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
}`,aC=`#include <common>
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
}`,lC=`uniform vec3 color;
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
}`,cC=`uniform float rotation;
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
}`,hC=`uniform vec3 diffuse;
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
}`,pt={alphahash_fragment:LT,alphahash_pars_fragment:DT,alphamap_fragment:NT,alphamap_pars_fragment:OT,alphatest_fragment:UT,alphatest_pars_fragment:FT,aomap_fragment:kT,aomap_pars_fragment:BT,batching_pars_vertex:zT,batching_vertex:VT,begin_vertex:GT,beginnormal_vertex:HT,bsdfs:WT,iridescence_fragment:$T,bumpmap_pars_fragment:qT,clipping_planes_fragment:XT,clipping_planes_pars_fragment:YT,clipping_planes_pars_vertex:jT,clipping_planes_vertex:ZT,color_fragment:KT,color_pars_fragment:JT,color_pars_vertex:QT,color_vertex:e1,common:t1,defaultnormal_vertex:n1,displacementmap_pars_vertex:i1,displacementmap_vertex:s1,emissivemap_fragment:r1,emissivemap_pars_fragment:o1,colorspace_fragment:a1,colorspace_pars_fragment:l1,envmap_fragment:c1,envmap_common_pars_fragment:h1,envmap_pars_fragment:u1,envmap_pars_vertex:d1,envmap_physical_pars_fragment:M1,envmap_vertex:f1,fog_vertex:p1,fog_pars_vertex:m1,fog_fragment:g1,fog_pars_fragment:_1,gradientmap_pars_fragment:y1,lightmap_pars_fragment:x1,lights_lambert_fragment:v1,lights_lambert_pars_fragment:b1,lights_pars_begin:S1,lights_toon_fragment:w1,lights_toon_pars_fragment:E1,lights_phong_fragment:T1,lights_phong_pars_fragment:A1,lights_physical_fragment:C1,lights_physical_pars_fragment:R1,lights_fragment_begin:P1,lights_fragment_maps:I1,lights_fragment_end:L1,lightprobes_pars_fragment:D1,logdepthbuf_fragment:N1,logdepthbuf_pars_fragment:O1,logdepthbuf_pars_vertex:U1,logdepthbuf_vertex:F1,map_fragment:k1,map_pars_fragment:B1,map_particle_fragment:z1,map_particle_pars_fragment:V1,metalnessmap_fragment:G1,metalnessmap_pars_fragment:H1,morphinstance_vertex:W1,morphcolor_vertex:$1,morphnormal_vertex:q1,morphtarget_pars_vertex:X1,morphtarget_vertex:Y1,normal_fragment_begin:j1,normal_fragment_maps:Z1,normal_pars_fragment:K1,normal_pars_vertex:J1,normal_vertex:Q1,normalmap_pars_fragment:eA,clearcoat_normal_fragment_begin:tA,clearcoat_normal_fragment_maps:nA,clearcoat_pars_fragment:iA,iridescence_pars_fragment:sA,opaque_fragment:rA,packing:oA,premultiplied_alpha_fragment:aA,project_vertex:lA,dithering_fragment:cA,dithering_pars_fragment:hA,roughnessmap_fragment:uA,roughnessmap_pars_fragment:dA,shadowmap_pars_fragment:fA,shadowmap_pars_vertex:pA,shadowmap_vertex:mA,shadowmask_pars_fragment:gA,skinbase_vertex:_A,skinning_pars_vertex:yA,skinning_vertex:xA,skinnormal_vertex:vA,specularmap_fragment:bA,specularmap_pars_fragment:SA,tonemapping_fragment:MA,tonemapping_pars_fragment:wA,transmission_fragment:EA,transmission_pars_fragment:TA,uv_pars_fragment:AA,uv_pars_vertex:CA,uv_vertex:RA,worldpos_vertex:PA,background_vert:IA,background_frag:LA,backgroundCube_vert:DA,backgroundCube_frag:NA,cube_vert:OA,cube_frag:UA,depth_vert:FA,depth_frag:kA,distance_vert:BA,distance_frag:zA,equirect_vert:VA,equirect_frag:GA,linedashed_vert:HA,linedashed_frag:WA,meshbasic_vert:$A,meshbasic_frag:qA,meshlambert_vert:XA,meshlambert_frag:YA,meshmatcap_vert:jA,meshmatcap_frag:ZA,meshnormal_vert:KA,meshnormal_frag:JA,meshphong_vert:QA,meshphong_frag:eC,meshphysical_vert:tC,meshphysical_frag:nC,meshtoon_vert:iC,meshtoon_frag:sC,points_vert:rC,points_frag:oC,shadow_vert:aC,shadow_frag:lC,sprite_vert:cC,sprite_frag:hC},Oe={common:{diffuse:{value:new ot(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new it},alphaMap:{value:null},alphaMapTransform:{value:new it},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new it}},envmap:{envMap:{value:null},envMapRotation:{value:new it},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new it}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new it}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new it},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new it},normalScale:{value:new Se(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new it},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new it}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new it}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new it}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new ot(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new ot(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new it},alphaTest:{value:0},uvTransform:{value:new it}},sprite:{diffuse:{value:new ot(16777215)},opacity:{value:1},center:{value:new Se(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new it},alphaMap:{value:null},alphaMapTransform:{value:new it},alphaTest:{value:0}}},ds={basic:{uniforms:Vn([Oe.common,Oe.specularmap,Oe.envmap,Oe.aomap,Oe.lightmap,Oe.fog]),vertexShader:pt.meshbasic_vert,fragmentShader:pt.meshbasic_frag},lambert:{uniforms:Vn([Oe.common,Oe.specularmap,Oe.envmap,Oe.aomap,Oe.lightmap,Oe.emissivemap,Oe.bumpmap,Oe.normalmap,Oe.displacementmap,Oe.fog,Oe.lights,{emissive:{value:new ot(0)},envMapIntensity:{value:1}}]),vertexShader:pt.meshlambert_vert,fragmentShader:pt.meshlambert_frag},phong:{uniforms:Vn([Oe.common,Oe.specularmap,Oe.envmap,Oe.aomap,Oe.lightmap,Oe.emissivemap,Oe.bumpmap,Oe.normalmap,Oe.displacementmap,Oe.fog,Oe.lights,{emissive:{value:new ot(0)},specular:{value:new ot(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:pt.meshphong_vert,fragmentShader:pt.meshphong_frag},standard:{uniforms:Vn([Oe.common,Oe.envmap,Oe.aomap,Oe.lightmap,Oe.emissivemap,Oe.bumpmap,Oe.normalmap,Oe.displacementmap,Oe.roughnessmap,Oe.metalnessmap,Oe.fog,Oe.lights,{emissive:{value:new ot(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:pt.meshphysical_vert,fragmentShader:pt.meshphysical_frag},toon:{uniforms:Vn([Oe.common,Oe.aomap,Oe.lightmap,Oe.emissivemap,Oe.bumpmap,Oe.normalmap,Oe.displacementmap,Oe.gradientmap,Oe.fog,Oe.lights,{emissive:{value:new ot(0)}}]),vertexShader:pt.meshtoon_vert,fragmentShader:pt.meshtoon_frag},matcap:{uniforms:Vn([Oe.common,Oe.bumpmap,Oe.normalmap,Oe.displacementmap,Oe.fog,{matcap:{value:null}}]),vertexShader:pt.meshmatcap_vert,fragmentShader:pt.meshmatcap_frag},points:{uniforms:Vn([Oe.points,Oe.fog]),vertexShader:pt.points_vert,fragmentShader:pt.points_frag},dashed:{uniforms:Vn([Oe.common,Oe.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:pt.linedashed_vert,fragmentShader:pt.linedashed_frag},depth:{uniforms:Vn([Oe.common,Oe.displacementmap]),vertexShader:pt.depth_vert,fragmentShader:pt.depth_frag},normal:{uniforms:Vn([Oe.common,Oe.bumpmap,Oe.normalmap,Oe.displacementmap,{opacity:{value:1}}]),vertexShader:pt.meshnormal_vert,fragmentShader:pt.meshnormal_frag},sprite:{uniforms:Vn([Oe.sprite,Oe.fog]),vertexShader:pt.sprite_vert,fragmentShader:pt.sprite_frag},background:{uniforms:{uvTransform:{value:new it},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:pt.background_vert,fragmentShader:pt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new it}},vertexShader:pt.backgroundCube_vert,fragmentShader:pt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:pt.cube_vert,fragmentShader:pt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:pt.equirect_vert,fragmentShader:pt.equirect_frag},distance:{uniforms:Vn([Oe.common,Oe.displacementmap,{referencePosition:{value:new I},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:pt.distance_vert,fragmentShader:pt.distance_frag},shadow:{uniforms:Vn([Oe.lights,Oe.fog,{color:{value:new ot(0)},opacity:{value:1}}]),vertexShader:pt.shadow_vert,fragmentShader:pt.shadow_frag}};ds.physical={uniforms:Vn([ds.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new it},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new it},clearcoatNormalScale:{value:new Se(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new it},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new it},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new it},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new it},sheen:{value:0},sheenColor:{value:new ot(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new it},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new it},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new it},transmissionSamplerSize:{value:new Se},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new it},attenuationDistance:{value:0},attenuationColor:{value:new ot(0)},specularColor:{value:new ot(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new it},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new it},anisotropyVector:{value:new Se},anisotropyMap:{value:null},anisotropyMapTransform:{value:new it}}]),vertexShader:pt.meshphysical_vert,fragmentShader:pt.meshphysical_frag};var ju={r:0,b:0,g:0},uC=new yt,bv=new it;bv.set(-1,0,0,0,1,0,0,0,1);function dC(i,e,t,n,s,r){let o=new ot(0),a=s===!0?0:1,l,c,h=null,u=0,d=null;function f(x){let C=x.isScene===!0?x.background:null;if(C&&C.isTexture){let b=x.backgroundBlurriness>0;C=e.get(C,b)}return C}function p(x){let C=!1,b=f(x);b===null?m(o,a):b&&b.isColor&&(m(b,1),C=!0);let A=i.xr.getEnvironmentBlendMode();A==="additive"?t.buffers.color.setClear(0,0,0,1,r):A==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(i.autoClear||C)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function _(x,C){let b=f(C);b&&b.isCubeTexture?(c===void 0&&(c=new Mt(new Wi(1,1,1),new cs({name:"BackgroundCubeMaterial",uniforms:Gr(ds.backgroundCube.uniforms),vertexShader:ds.backgroundCube.vertexShader,fragmentShader:ds.backgroundCube.fragmentShader,side:Qn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(A,S,y){this.matrixWorld.copyPosition(y.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=b,c.material.uniforms.backgroundBlurriness.value=C.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=C.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(uC.makeRotationFromEuler(C.backgroundRotation)).transpose(),b.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(bv),c.material.toneMapped=St.getTransfer(b.colorSpace)!==Dt,(h!==b||u!==b.version||d!==i.toneMapping)&&(c.material.needsUpdate=!0,h=b,u=b.version,d=i.toneMapping),c.layers.enableAll(),x.unshift(c,c.geometry,c.material,0,0,null)):b&&b.isTexture&&(l===void 0&&(l=new Mt(new ml(2,2),new cs({name:"BackgroundMaterial",uniforms:Gr(ds.background.uniforms),vertexShader:ds.background.vertexShader,fragmentShader:ds.background.fragmentShader,side:ur,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=b,l.material.uniforms.backgroundIntensity.value=C.backgroundIntensity,l.material.toneMapped=St.getTransfer(b.colorSpace)!==Dt,b.matrixAutoUpdate===!0&&b.updateMatrix(),l.material.uniforms.uvTransform.value.copy(b.matrix),(h!==b||u!==b.version||d!==i.toneMapping)&&(l.material.needsUpdate=!0,h=b,u=b.version,d=i.toneMapping),l.layers.enableAll(),x.unshift(l,l.geometry,l.material,0,0,null))}function m(x,C){x.getRGB(ju,Qp(i)),t.buffers.color.setClear(ju.r,ju.g,ju.b,C,r)}function g(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(x,C=1){o.set(x),a=C,m(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(x){a=x,m(o,a)},render:p,addToRenderList:_,dispose:g}}function fC(i,e){let t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=d(null),r=s,o=!1;function a(L,V,W,O,G){let j=!1,z=u(L,O,W,V);r!==z&&(r=z,c(r.object)),j=f(L,O,W,G),j&&p(L,O,W,G),G!==null&&e.update(G,i.ELEMENT_ARRAY_BUFFER),(j||o)&&(o=!1,b(L,V,W,O),G!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,e.get(G).buffer))}function l(){return i.createVertexArray()}function c(L){return i.bindVertexArray(L)}function h(L){return i.deleteVertexArray(L)}function u(L,V,W,O){let G=O.wireframe===!0,j=n[V.id];j===void 0&&(j={},n[V.id]=j);let z=L.isInstancedMesh===!0?L.id:0,ce=j[z];ce===void 0&&(ce={},j[z]=ce);let Z=ce[W.id];Z===void 0&&(Z={},ce[W.id]=Z);let J=Z[G];return J===void 0&&(J=d(l()),Z[G]=J),J}function d(L){let V=[],W=[],O=[];for(let G=0;G<t;G++)V[G]=0,W[G]=0,O[G]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:V,enabledAttributes:W,attributeDivisors:O,object:L,attributes:{},index:null}}function f(L,V,W,O){let G=r.attributes,j=V.attributes,z=0,ce=W.getAttributes();for(let Z in ce)if(ce[Z].location>=0){let ie=G[Z],fe=j[Z];if(fe===void 0&&(Z==="instanceMatrix"&&L.instanceMatrix&&(fe=L.instanceMatrix),Z==="instanceColor"&&L.instanceColor&&(fe=L.instanceColor)),ie===void 0||ie.attribute!==fe||fe&&ie.data!==fe.data)return!0;z++}return r.attributesNum!==z||r.index!==O}function p(L,V,W,O){let G={},j=V.attributes,z=0,ce=W.getAttributes();for(let Z in ce)if(ce[Z].location>=0){let ie=j[Z];ie===void 0&&(Z==="instanceMatrix"&&L.instanceMatrix&&(ie=L.instanceMatrix),Z==="instanceColor"&&L.instanceColor&&(ie=L.instanceColor));let fe={};fe.attribute=ie,ie&&ie.data&&(fe.data=ie.data),G[Z]=fe,z++}r.attributes=G,r.attributesNum=z,r.index=O}function _(){let L=r.newAttributes;for(let V=0,W=L.length;V<W;V++)L[V]=0}function m(L){g(L,0)}function g(L,V){let W=r.newAttributes,O=r.enabledAttributes,G=r.attributeDivisors;W[L]=1,O[L]===0&&(i.enableVertexAttribArray(L),O[L]=1),G[L]!==V&&(i.vertexAttribDivisor(L,V),G[L]=V)}function x(){let L=r.newAttributes,V=r.enabledAttributes;for(let W=0,O=V.length;W<O;W++)V[W]!==L[W]&&(i.disableVertexAttribArray(W),V[W]=0)}function C(L,V,W,O,G,j,z){z===!0?i.vertexAttribIPointer(L,V,W,G,j):i.vertexAttribPointer(L,V,W,O,G,j)}function b(L,V,W,O){_();let G=O.attributes,j=W.getAttributes(),z=V.defaultAttributeValues;for(let ce in j){let Z=j[ce];if(Z.location>=0){let J=G[ce];if(J===void 0&&(ce==="instanceMatrix"&&L.instanceMatrix&&(J=L.instanceMatrix),ce==="instanceColor"&&L.instanceColor&&(J=L.instanceColor)),J!==void 0){let ie=J.normalized,fe=J.itemSize,de=e.get(J);if(de===void 0)continue;let Q=de.buffer,ge=de.type,xe=de.bytesPerElement,Pe=ge===i.INT||ge===i.UNSIGNED_INT||J.gpuType===uu;if(J.isInterleavedBufferAttribute){let we=J.data,Xe=we.isInterleavedBuffer===!0?we.stride:we.itemSize,at=J.offset;if(we.isInstancedInterleavedBuffer||we.isInstancedBufferAttribute){for(let $e=0;$e<Z.locationSize;$e++)g(Z.location+$e,we.meshPerAttribute);L.isInstancedMesh!==!0&&O._maxInstanceCount===void 0&&(O._maxInstanceCount=we.meshPerAttribute*we.count)}else for(let $e=0;$e<Z.locationSize;$e++)m(Z.location+$e);i.bindBuffer(i.ARRAY_BUFFER,Q);for(let $e=0;$e<Z.locationSize;$e++)C(Z.location+$e,fe/Z.locationSize,ge,ie,Xe*xe,(at+fe/Z.locationSize*$e)*xe,Pe)}else{if(J.isInstancedBufferAttribute){for(let we=0;we<Z.locationSize;we++)g(Z.location+we,J.meshPerAttribute);L.isInstancedMesh!==!0&&O._maxInstanceCount===void 0&&(O._maxInstanceCount=J.meshPerAttribute*J.count)}else for(let we=0;we<Z.locationSize;we++)m(Z.location+we);i.bindBuffer(i.ARRAY_BUFFER,Q);for(let we=0;we<Z.locationSize;we++)C(Z.location+we,fe/Z.locationSize,ge,ie,fe*xe,fe/Z.locationSize*we*xe,Pe)}}else if(z!==void 0){let ie=z[ce];if(ie!==void 0)switch(ie.length){case 2:i.vertexAttrib2fv(Z.location,ie);break;case 3:i.vertexAttrib3fv(Z.location,ie);break;case 4:i.vertexAttrib4fv(Z.location,ie);break;default:i.vertexAttrib1fv(Z.location,ie)}}}}x()}function A(){U();for(let L in n){let V=n[L];for(let W in V){let O=V[W];for(let G in O){let j=O[G];for(let z in j)h(j[z].object),delete j[z];delete O[G]}}delete n[L]}}function S(L){if(n[L.id]===void 0)return;let V=n[L.id];for(let W in V){let O=V[W];for(let G in O){let j=O[G];for(let z in j)h(j[z].object),delete j[z];delete O[G]}}delete n[L.id]}function y(L){for(let V in n){let W=n[V];for(let O in W){let G=W[O];if(G[L.id]===void 0)continue;let j=G[L.id];for(let z in j)h(j[z].object),delete j[z];delete G[L.id]}}}function M(L){for(let V in n){let W=n[V],O=L.isInstancedMesh===!0?L.id:0,G=W[O];if(G!==void 0){for(let j in G){let z=G[j];for(let ce in z)h(z[ce].object),delete z[ce];delete G[j]}delete W[O],Object.keys(W).length===0&&delete n[V]}}}function U(){N(),o=!0,r!==s&&(r=s,c(r.object))}function N(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:U,resetDefaultState:N,dispose:A,releaseStatesOfGeometry:S,releaseStatesOfObject:M,releaseStatesOfProgram:y,initAttributes:_,enableAttribute:m,disableUnusedAttributes:x}}function pC(i,e,t){let n;function s(l){n=l}function r(l,c){i.drawArrays(n,l,c),t.update(c,n,1)}function o(l,c,h){h!==0&&(i.drawArraysInstanced(n,l,c,h),t.update(c,n,h))}function a(l,c,h){if(h===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,h);let d=0;for(let f=0;f<h;f++)d+=c[f];t.update(d,n,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function mC(i,e,t,n){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let y=e.get("EXT_texture_filter_anisotropic");s=i.getParameter(y.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(y){return!(y!==Yi&&n.convert(y)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(y){let M=y===Xi&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(y!==ii&&y!==qi&&!M&&n.convert(y)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function l(y){if(y==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";y="mediump"}return y==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",h=l(c);h!==c&&(Ze("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let u=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),d=t.logarithmicDepthBuffer===!0&&u===!1;t.reversedDepthBuffer===!0&&u===!1&&Ze("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&u===!0&&Ze("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),p=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),_=i.getParameter(i.MAX_TEXTURE_SIZE),m=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),g=i.getParameter(i.MAX_VERTEX_ATTRIBS),x=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),C=i.getParameter(i.MAX_VARYING_VECTORS),b=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),A=i.getParameter(i.MAX_SAMPLES),S=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:u,maxTextures:f,maxVertexTextures:p,maxTextureSize:_,maxCubemapSize:m,maxAttributes:g,maxVertexUniforms:x,maxVaryings:C,maxFragmentUniforms:b,maxSamples:A,samples:S}}function gC(i){let e=this,t=null,n=0,s=!1,r=!1,o=new _i,a=new it,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,d){let f=u.length!==0||d||n!==0||s;return s=d,n=u.length,f},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,d){t=h(u,d,0)},this.setState=function(u,d,f){let p=u.clippingPlanes,_=u.clipIntersection,m=u.clipShadows,g=i.get(u);if(!s||p===null||p.length===0||r&&!m)r?h(null):c();else{let x=r?0:n,C=x*4,b=g.clippingState||null;l.value=b,b=h(p,d,C,f);for(let A=0;A!==C;++A)b[A]=t[A];g.clippingState=b,this.numIntersection=_?this.numPlanes:0,this.numPlanes+=x}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=n>0),e.numPlanes=n,e.numIntersection=0}function h(u,d,f,p){let _=u!==null?u.length:0,m=null;if(_!==0){if(m=l.value,p!==!0||m===null){let g=f+_*4,x=d.matrixWorldInverse;a.getNormalMatrix(x),(m===null||m.length<g)&&(m=new Float32Array(g));for(let C=0,b=f;C!==_;++C,b+=4)o.copy(u[C]).applyMatrix4(x,a),o.normal.toArray(m,b),m[b+3]=o.constant}l.value=m,l.needsUpdate=!0}return e.numPlanes=_,e.numIntersection=0,m}}var Ul=class extends xi{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let n={width:e,height:e,depth:1},s=[n,n,n,n,n,n];this.texture=new al(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new Wi(5,5,5),r=new cs({name:"CubemapFromEquirect",uniforms:Gr(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:Qn,blending:Os});r.uniforms.tEquirect.value=t;let o=new Mt(s,r),a=t.minFilter;return t.minFilter===Us&&(t.minFilter=Kn),new Zo(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,n=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,n,s);e.setRenderTarget(r)}},Qx=256,_C=3,yC=20,Sv=256,Mv=16,xC=3,vC=new I,bC=new ot,Ku=class i{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Zo(1,10,null),this._boxMesh=new Mt(new Wi(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,n=.1,s=100,r={}){let{size:o=256,position:a=vC}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),h=this._getSourceTarget(!0);t>0&&(h.texture.mipmapsAutoUpdate=!1);let u=l.autoClear,d=l.autoClearColor,f=l.autoClearDepth,p=l.autoClearStencil,_=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,_===null&&(e.background=l.getClearColor(bC));let m=new Zo(n,s,h);return m.position.copy(a),m.update(l,e),l.autoClear=u,l.autoClearColor=d,l.autoClearDepth=f,l.autoClearStencil=p,e.background=_,t>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=nv(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=tv(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(Qx,Yp(e))}_fromTexture(e,t){e.mapping===zr||e.mapping===ea?this._setSize(e.image.length===0?Qx:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let n=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(n),n}_allocateTarget(){let e=this._cubeSize,t=ev(e,!1,!1),n=Math.log2(e)-_C;for(let s=0;s<=n;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==t||e&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=ev(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===zr||e.mapping===ea?(this._cubemapMaterial===null&&(this._cubemapMaterial=nv()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=tv()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=SC(),this._integrationMaterial=MC());let t=this._cubeSize,n=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/Mv);for(let o=0;o<=n;o++){let a=i.lodToRoughness(o,n);if(o>n-xC)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(Sv*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=wC());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,n),s.envMap.value=e.texture,this._renderCube(r,0,n)}};function ev(i,e,t){return new Ul(i,{minFilter:Us,generateMipmaps:e,type:Xi,colorSpace:Ja,depthBuffer:t})}function Fl(i,e,t){return new cs({name:i,uniforms:e,vertexShader:pt.cube_vert,fragmentShader:t,side:Qn,blending:Os,depthTest:!1,depthWrite:!1})}function SC(){return Fl("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Sv}u

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
	`)}function MC(){return Fl("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Mv}},`

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
	`)}function wC(){return Fl("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${yC}
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
	`)}function tv(){return Fl("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function nv(){return Fl("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function EC(i){let e=new WeakMap,t=new WeakMap,n=null;function s(d,f=!1){return d==null?null:f?o(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===lu||f===cu)if(e.has(d)){let p=e.get(d).texture;return a(p,d.mapping)}else{let p=d.image;if(p&&p.height>0){let _=new Ul(p.height);return _.fromEquirectangularTexture(i,d),e.set(d,_),d.addEventListener("dispose",c),a(_.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,p=f===lu||f===cu,_=f===zr||f===ea;if(p||_){let m=t.get(d),g=m!==void 0?m.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==g)return n===null&&(n=new Ku(i)),m=p?n.fromEquirectangular(d,m):n.fromCubemap(d,m),m.texture.pmremVersion=d.pmremVersion,t.set(d,m),m.texture;if(m!==void 0)return m.texture;{let x=d.image;return p&&x&&x.height>0||_&&x&&l(x)?(n===null&&(n=new Ku(i)),m=p?n.fromEquirectangular(d):n.fromCubemap(d),m.texture.pmremVersion=d.pmremVersion,t.set(d,m),d.addEventListener("dispose",h),m.texture):null}}}return d}function a(d,f){return f===lu?d.mapping=zr:f===cu&&(d.mapping=ea),d}function l(d){let f=0,p=6;for(let _=0;_<p;_++)d[_]!==void 0&&f++;return f===p}function c(d){let f=d.target;f.removeEventListener("dispose",c);let p=e.get(f);p!==void 0&&(e.delete(f),p.dispose())}function h(d){let f=d.target;f.removeEventListener("dispose",h);let p=t.get(f);p!==void 0&&(t.delete(f),p.dispose())}function u(){e=new WeakMap,t=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:u}}function TC(i){let e={};function t(n){if(e[n]!==void 0)return e[n];let s=i.getExtension(n);return e[n]=s,s}return{has:function(n){return t(n)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(n){let s=t(n);return s===null&&Xa("WebGLRenderer: "+n+" extension not supported."),s}}}function AC(i,e,t,n){let s={},r=new WeakMap,o=new FinalizationRegistry(p=>delete s[p]);function a(p){l(p.target)}function l(p){p.index!==null&&e.remove(p.index);for(let m in p.attributes)e.remove(p.attributes[m]);p.removeEventListener("dispose",a),delete s[p.id],o.unregister(p);let _=r.get(p);_&&(e.remove(_),r.delete(p)),n.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,t.memory.geometries--}function c(p,_){return s[_.id]!==void 0||(_.addEventListener("dispose",a),s[_.id]=new WeakRef(_),o.register(_,_.id,_),t.memory.geometries++),_}function h(p){let _=p.attributes;for(let m in _)e.update(_[m],i.ARRAY_BUFFER)}function u(p){let _=p.index,m=p.attributes.position,g=0;if(m===void 0)return;let x=_!==null?_.array.length:m.array.length/3-1,C=m.count>=65535?sl:il,b=new C(Math.ceil(x/3)*6,1),A=b.array;if(_!==null){let y=_.array;g=_.version;for(let M=0,U=0;M<x;M+=3){let N=y[M+0],L=y[M+1],V=y[M+2];A[U++]=N,A[U++]=L,A[U++]=L,A[U++]=V,A[U++]=V,A[U++]=N}}else{g=m.version;for(let y=0,M=0;y<x;y+=3){let U=y+0,N=y+1,L=y+2;A[M++]=U,A[M++]=N,A[M++]=N,A[M++]=L,A[M++]=L,A[M++]=U}}b.version=g;let S=r.get(p);S&&e.remove(S),r.set(p,b)}function d(p){let _=r.get(p);if(_){let m=p.index;m!==null&&_.version<m.version&&u(p)}else u(p);return r.get(p)}function f(){for(let p in s){let _=s[p].deref();_!==void 0&&l(_)}}return{get:c,update:h,getWireframeAttribute:d,dispose:f}}function CC(i,e,t){let n;function s(u){n=u}let r,o;function a(u){r=u.type,o=u.bytesPerElement}function l(u,d){i.drawElements(n,d,r,u*o),t.update(d,n,1)}function c(u,d,f){f!==0&&(i.drawElementsInstanced(n,d,r,u*o,f),t.update(d,n,f))}function h(u,d,f){if(f===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,d,0,r,u,0,f);let _=0;for(let m=0;m<f;m++)_+=d[m];t.update(_,n,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function RC(i){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(t.calls++,o){case i.TRIANGLES:t.triangles+=a*(r/3);break;case i.LINES:t.lines+=a*(r/2);break;case i.LINE_STRIP:t.lines+=a*(r-1);break;case i.LINE_LOOP:t.lines+=a*r;break;case i.POINTS:t.points+=a*r;break;default:Qe("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:n}}function PC(i,e,t){let n=new WeakMap,s=new Jt;function r(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=h!==void 0?h.length:0,d=n.get(a);if(d===void 0||d.count!==u){let N=function(){M.dispose(),n.delete(a),a.removeEventListener("dispose",N)};var f=N;d!==void 0&&d.texture.dispose();let p=a.morphAttributes.position!==void 0,_=a.morphAttributes.normal!==void 0,m=a.morphAttributes.color!==void 0,g=a.morphAttributes.position||[],x=a.morphAttributes.normal||[],C=a.morphAttributes.color||[],b=0;p===!0&&(b=1),_===!0&&(b=2),m===!0&&(b=3);let A=a.attributes.position.count*b,S=1;A>e.maxTextureSize&&(S=Math.ceil(A/e.maxTextureSize),A=e.maxTextureSize);let y=new Float32Array(A*S*4*u),M=new nl(y,A,S,u);M.type=qi,M.needsUpdate=!0;let U=b*4;for(let L=0;L<u;L++){let V=g[L],W=x[L],O=C[L],G=A*S*4*L;for(let j=0;j<V.count;j++){let z=j*U;p===!0&&(s.fromBufferAttribute(V,j),y[G+z+0]=s.x,y[G+z+1]=s.y,y[G+z+2]=s.z,y[G+z+3]=0),_===!0&&(s.fromBufferAttribute(W,j),y[G+z+4]=s.x,y[G+z+5]=s.y,y[G+z+6]=s.z,y[G+z+7]=0),m===!0&&(s.fromBufferAttribute(O,j),y[G+z+8]=s.x,y[G+z+9]=s.y,y[G+z+10]=s.z,y[G+z+11]=O.itemSize===4?s.w:1)}}d={count:u,texture:M,size:new Se(A,S)},n.set(a,d),a.addEventListener("dispose",N)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,t);else{let p=0;for(let m=0;m<c.length;m++)p+=c[m];let _=a.morphTargetsRelative?1:1-p;l.getUniforms().setValue(i,"morphTargetBaseInfluence",_),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",d.texture,t),l.getUniforms().setValue(i,"morphTargetsTextureSize",d.size)}return{update:r}}function IC(i,e,t,n,s){let r=new WeakMap;function o(c){let h=s.render.frame,u=c.geometry,d=e.get(c,u);if(r.get(d)!==h&&(e.update(d),r.set(d,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(t.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,i.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==h&&(f.update(),r.set(f,h))}return d}function a(){r=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),n.releaseStatesOfObject(h),t.remove(h.instanceMatrix),h.instanceColor!==null&&t.remove(h.instanceColor)}return{update:o,dispose:a}}var LC={[Ap]:"LINEAR_TONE_MAPPING",[Cp]:"REINHARD_TONE_MAPPING",[Rp]:"CINEON_TONE_MAPPING",[Pp]:"ACES_FILMIC_TONE_MAPPING",[Lp]:"AGX_TONE_MAPPING",[Dp]:"NEUTRAL_TONE_MAPPING",[Ip]:"CUSTOM_TONE_MAPPING"};function DC(i,e,t,n,s,r){let o=new xi(e,t,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,h=new Nt;h.setAttribute("position",new ut([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new ut([0,2,0,0,2,0],2));let u=new Xh({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),d=new Mt(h,u),f=new kr(-1,1,1,-1,0,1),p=null,_=null,m=!1,g,x=null,C=[],b=!1;this.setSize=function(A,S){o.setSize(A,S),a!==null&&a.setSize(A,S),l!==null&&l.setSize(A,S);for(let y=0;y<C.length;y++){let M=C[y];M.setSize&&M.setSize(A,S)}},this.setEffects=function(A){C=A,b=C.length>0&&C[0].isRenderPass===!0;let S=o.width,y=o.height;C.length>0&&a===null&&(a=new xi(S,y,{type:Xi,depthBuffer:!1,stencilBuffer:!1}),l=new xi(S,y,{type:Xi,depthBuffer:!1,stencilBuffer:!1}));let M=s===!0&&C.some(U=>U.needsDepthTexture===!0);M!==(o.depthTexture!==null)&&(M===!0&&c===null&&(c=new Ds(S,y),r===!0&&(c.format=Fs,c.type=Vr)),o.dispose(),o.depthTexture=M?c:null,o.resolveDepthBuffer=M,o.storeMultisampledDepthBuffer=M);for(let U=0;U<C.length;U++){let N=C[U];N.setSize&&N.setSize(S,y),M&&N.needsDepthTexture===!0&&N.setDepthTexture&&N.setDepthTexture(c)}},this.begin=function(A,S){if(m||A.toneMapping===hs&&C.length===0)return!1;if(x=S,S!==null){let y=S.width,M=S.height;(o.width!==y||o.height!==M)&&this.setSize(y,M)}return b===!1&&A.setRenderTarget(o),g=A.toneMapping,A.toneMapping=hs,!0},this.hasRenderPass=function(){return b},this.end=function(A,S){A.toneMapping=g,m=!0;let y=o,M=a;for(let U=0;U<C.length;U++){let N=C[U];N.enabled!==!1&&(N.render(A,M,y,S),N.needsSwap!==!1&&(y=M,M=M===a?l:a))}if(p!==A.outputColorSpace||_!==A.toneMapping){p=A.outputColorSpace,_=A.toneMapping,u.defines={},St.getTransfer(p)===Dt&&(u.defines.SRGB_TRANSFER="");let U=LC[_];U&&(u.defines[U]=""),u.needsUpdate=!0}u.uniforms.tDiffuse.value=y.texture,A.setRenderTarget(x),A.render(d,f),x=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),h.dispose(),u.dispose()}}var wv=new Jn,Ev=new Ds(1,1),Tv=new cl(1),Av=new nl,Cv=new Dh,Rv=new al,iv=[],sv=[],rv=new Float32Array(16),ov=new Float32Array(9),av=new Float32Array(4);function ia(i,e,t){let n=i[0];if(n<=0||n>0)return i;let s=e*t,r=iv[s];if(r===void 0&&(r=new Float32Array(s),iv[s]=r),e!==0){n.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,i[o].toArray(r,a)}return r}function En(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}function Tn(i,e){for(let t=0,n=e.length;t<n;t++)i[t]=e[t]}function Qu(i,e){let t=sv[e];t===void 0&&(t=new Int32Array(e),sv[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}function NC(i,e){let t=this.cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}function OC(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(En(t,e))return;i.uniform2fv(this.addr,e),Tn(t,e)}}function UC(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(En(t,e))return;i.uniform3fv(this.addr,e),Tn(t,e)}}function FC(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(En(t,e))return;i.uniform4fv(this.addr,e),Tn(t,e)}}function kC(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(En(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),Tn(t,e)}else{if(En(t,n))return;av.set(n),i.uniformMatrix2fv(this.addr,!1,av),Tn(t,n)}}function BC(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(En(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),Tn(t,e)}else{if(En(t,n))return;ov.set(n),i.uniformMatrix3fv(this.addr,!1,ov),Tn(t,n)}}function zC(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(En(t,e))return;i.uniformMatrix4fv(this.addr,!1,e),Tn(t,e)}else{if(En(t,n))return;rv.set(n),i.uniformMatrix4fv(this.addr,!1,rv),Tn(t,n)}}function VC(i,e){let t=this.cache;t[0]!==e&&(i.uniform1i(this.addr,e),t[0]=e)}function GC(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(En(t,e))return;i.uniform2iv(this.addr,e),Tn(t,e)}}function HC(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(En(t,e))return;i.uniform3iv(this.addr,e),Tn(t,e)}}function WC(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(En(t,e))return;i.uniform4iv(this.addr,e),Tn(t,e)}}function $C(i,e){let t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}function qC(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(En(t,e))return;i.uniform2uiv(this.addr,e),Tn(t,e)}}function XC(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(En(t,e))return;i.uniform3uiv(this.addr,e),Tn(t,e)}}function YC(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(En(t,e))return;i.uniform4uiv(this.addr,e),Tn(t,e)}}function ed(i){return i.version===0&&(i.compareFunction=Wp,i.needsUpdate=!0),i}function jC(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=ed(Ev):r=wv,t.setTexture2D(e||r,s)}function ZC(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture3D(e||Cv,s)}function KC(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=ed(Tv):r=Rv,t.setTextureCube(e||r,s)}function JC(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture2DArray(e||Av,s)}function QC(i){switch(i){case 5126:return NC;case 35664:return OC;case 35665:return UC;case 35666:return FC;case 35674:return kC;case 35675:return BC;case 35676:return zC;case 5124:case 35670:return VC;case 35667:case 35671:return GC;case 35668:case 35672:return HC;case 35669:case 35673:return WC;case 5125:return $C;case 36294:return qC;case 36295:return XC;case 36296:return YC;case 35678:case 36198:case 36298:case 36306:case 35682:return jC;case 35679:case 36299:case 36307:return ZC;case 35680:case 36300:case 36308:case 36293:return KC;case 36289:case 36303:case 36311:case 36292:return JC}}function eR(i,e){i.uniform1fv(this.addr,e)}function tR(i,e){let t=ia(e,this.size,2);i.uniform2fv(this.addr,t)}function nR(i,e){let t=ia(e,this.size,3);i.uniform3fv(this.addr,t)}function iR(i,e){let t=ia(e,this.size,4);i.uniform4fv(this.addr,t)}function sR(i,e){let t=ia(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}function rR(i,e){let t=ia(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}function oR(i,e){let t=ia(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}function aR(i,e){i.uniform1iv(this.addr,e)}function lR(i,e){i.uniform2iv(this.addr,e)}function cR(i,e){i.uniform3iv(this.addr,e)}function hR(i,e){i.uniform4iv(this.addr,e)}function uR(i,e){i.uniform1uiv(this.addr,e)}function dR(i,e){i.uniform2uiv(this.addr,e)}function fR(i,e){i.uniform3uiv(this.addr,e)}function pR(i,e){i.uniform4uiv(this.addr,e)}function mR(i,e,t){let n=this.cache,s=e.length,r=Qu(t,s);En(n,r)||(i.uniform1iv(this.addr,r),Tn(n,r));let o;this.type===i.SAMPLER_2D_SHADOW?o=ed(Ev):o=wv;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function gR(i,e,t){let n=this.cache,s=e.length,r=Qu(t,s);En(n,r)||(i.uniform1iv(this.addr,r),Tn(n,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||Cv,r[o])}function _R(i,e,t){let n=this.cache,s=e.length,r=Qu(t,s);En(n,r)||(i.uniform1iv(this.addr,r),Tn(n,r));let o;this.type===i.SAMPLER_CUBE_SHADOW?o=ed(Tv):o=Rv;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function yR(i,e,t){let n=this.cache,s=e.length,r=Qu(t,s);En(n,r)||(i.uniform1iv(this.addr,r),Tn(n,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||Av,r[o])}function xR(i){switch(i){case 5126:return eR;case 35664:return tR;case 35665:return nR;case 35666:return iR;case 35674:return sR;case 35675:return rR;case 35676:return oR;case 5124:case 35670:return aR;case 35667:case 35671:return lR;case 35668:case 35672:return cR;case 35669:case 35673:return hR;case 5125:return uR;case 36294:return dR;case 36295:return fR;case 36296:return pR;case 35678:case 36198:case 36298:case 36306:case 35682:return mR;case 35679:case 36299:case 36307:return gR;case 35680:case 36300:case 36308:case 36293:return _R;case 36289:case 36303:case 36311:case 36292:return yR}}var rm=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=QC(t.type)}},om=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=xR(t.type)}},am=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],n)}}},im=/(\w+)(\])?(\[|\.)?/g;function lv(i,e){i.seq.push(e),i.map[e.id]=e}function vR(i,e,t){let n=i.name,s=n.length;for(im.lastIndex=0;;){let r=im.exec(n),o=im.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){lv(t,c===void 0?new rm(a,i,e):new om(a,i,e));break}else{let u=t.map[a];u===void 0&&(u=new am(a),lv(t,u)),t=u}}}var na=class{constructor(e,t){this.seq=[],this.map={};let n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);vR(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,n,s){let r=this.map[t];r!==void 0&&r.setValue(e,n,s)}setOptional(e,t,n){let s=t[n];s!==void 0&&this.setValue(e,n,s)}static upload(e,t,n,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let n=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&n.push(o)}return n}};function cv(i,e,t){let n=i.createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}var bR=37297,SR=0;function MR(i,e){let t=i.split(`
`),n=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return n.join(`
`)}var hv=new it;function wR(i){St._getMatrix(hv,St.workingColorSpace,i);let e=`mat3( ${hv.elements.map(t=>t.toFixed(4))} )`;switch(St.getTransfer(i)){case Qa:return[e,"LinearTransferOETF"];case Dt:return[e,"sRGBTransferOETF"];default:return Ze("WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}function uv(i,e,t){let n=i.getShaderParameter(e,i.COMPILE_STATUS),r=(i.getShaderInfoLog(e)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+MR(i.getShaderSource(e),a)}else return r}function ER(i,e){let t=wR(e);return[`vec4 ${i}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var TR={[Ap]:"Linear",[Cp]:"Reinhard",[Rp]:"Cineon",[Pp]:"ACESFilmic",[Lp]:"AgX",[Dp]:"Neutral",[Ip]:"Custom"};function AR(i,e){let t=TR[e];return t===void 0?(Ze("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var Zu=new I;function CR(){St.getLuminanceCoefficients(Zu);let i=Zu.x.toFixed(4),e=Zu.y.toFixed(4),t=Zu.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function RR(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Ol).join(`
`)}function PR(i){let e=[];for(let t in i){let n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.join(`
`)}function IR(i,e){let t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(e,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:i.getAttribLocation(e,o),locationSize:a}}return t}function Ol(i){return i!==""}function dv(i,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function fv(i,e){return i.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var LR=/^[ \t]*#include +<([\w\d./]+)>/gm;function lm(i){return i.replace(LR,DR)}function DR(i,e){let t=pt[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return lm(t)}var NR=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function pv(i){return i.replace(NR,OR)}function OR(i,e,t,n){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function mv(i){let e=`precision ${i.precision} float;
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
#define LOW_PRECISION`),e}var UR={[Tl]:"SHADOWMAP_TYPE_PCF",[Jo]:"SHADOWMAP_TYPE_VSM"};function FR(i){return UR[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var kR={[ea]:"ENVMAP_MODE_REFRACTION"};function BR(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":kR[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var zR={[Qo]:"ENVMAP_BLENDING_MULTIPLY",[Dx]:"ENVMAP_BLENDING_MIX",[Nx]:"ENVMAP_BLENDING_ADD"};function VR(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":zR[i.combine]||"ENVMAP_BLENDING_NONE"}function GR(i,e,t,n){let s=i.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=FR(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=BR(t),u=VR(t),d=RR(t),f=PR(r),p=s.createProgram(),_,m,g=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(_=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(Ol).join(`
`),_.length>0&&(_+=`
`),m=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(Ol).join(`
`),m.length>0&&(m+=`
`)):(_=[mv(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+h:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Ol).join(`
`),m=[mv(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+h:"",t.envMap?"#define "+u:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==hs?"#define TONE_MAPPING":"",t.toneMapping!==hs?pt.tonemapping_pars_fragment:"",t.toneMapping!==hs?AR("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",pt.colorspace_pars_fragment,ER("linearToOutputTexel",t.outputColorSpace),CR(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(Ol).join(`
`)),o=lm(o),o=dv(o,t),o=fv(o,t),a=lm(a),a=dv(a,t),a=fv(a,t),o=pv(o),a=pv(a),t.isRawShaderMaterial!==!0&&(g=`#version 300 es
`,_=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+_,m=["#define varying in",t.glslVersion===qp?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===qp?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let x=g+_+o,C=g+m+a,b=cv(s,s.VERTEX_SHADER,x),A=cv(s,s.FRAGMENT_SHADER,C);s.attachShader(p,b),s.attachShader(p,A),t.index0AttributeName!==void 0?s.bindAttribLocation(p,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(p,0,"position"),s.linkProgram(p);function S(N){if(i.debug.checkShaderErrors){let L=s.getProgramInfoLog(p)||"",V=s.getShaderInfoLog(b)||"",W=s.getShaderInfoLog(A)||"",O=L.trim(),G=V.trim(),j=W.trim(),z=!0,ce=!0;if(s.getProgramParameter(p,s.LINK_STATUS)===!1)if(z=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,p,b,A);else{let Z=uv(s,b,"vertex"),J=uv(s,A,"fragment");Qe("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(p,s.VALIDATE_STATUS)+`

Material Name: `+N.name+`
Material Type: `+N.type+`

Program Info Log: `+O+`
`+Z+`
`+J)}else O!==""?Ze("WebGLProgram: Program Info Log:",O):(G===""||j==="")&&(ce=!1);ce&&(N.diagnostics={runnable:z,programLog:O,vertexShader:{log:G,prefix:_},fragmentShader:{log:j,prefix:m}})}s.deleteShader(b),s.deleteShader(A),y=new na(s,p),M=IR(s,p)}let y;this.getUniforms=function(){return y===void 0&&S(this),y};let M;this.getAttributes=function(){return M===void 0&&S(this),M};let U=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return U===!1&&(U=s.getProgramParameter(p,bR)),U},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(p),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=SR++,this.cacheKey=e,this.usedTimes=1,this.program=p,this.vertexShader=b,this.fragmentShader=A,this}var HR=0,cm=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,n){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let n of t)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){let t=this.shaderCache,n=t.get(e);return n===void 0&&(n=new hm(e),t.set(e,n)),n}},hm=class{constructor(e){this.id=HR++,this.code=e,this.usedTimes=0}};function WR(i){return i===fr||i===Ll||i===Dl}function $R(i,e,t,n,s,r){let o=new Ho,a=new cm,l=new Set,c=[],h=new Map,u=n.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(y){return l.add(y),y===0?"uv":`uv${y}`}function p(y,M,U,N,L,V){let W=N.fog,O=L.geometry,G=y.isMeshStandardMaterial||y.isMeshLambertMaterial||y.isMeshPhongMaterial?N.environment:null,j=y.isMeshStandardMaterial||y.isMeshLambertMaterial&&!y.envMap||y.isMeshPhongMaterial&&!y.envMap,z=e.get(y.envMap||G,j),ce=d[y.type],Z=n.precision;y.precision!==null&&(Z=n.getMaxPrecision(y.precision),Z!==y.precision&&Ze("WebGLProgram.getParameters:",y.precision,"not supported, using",Z,"instead."));let J=O.morphAttributes.position||O.morphAttributes.normal||O.morphAttributes.color,ie=J!==void 0?J.length:0,fe=0;O.morphAttributes.position!==void 0&&(fe=1),O.morphAttributes.normal!==void 0&&(fe=2),O.morphAttributes.color!==void 0&&(fe=3);let de,Q,ge,xe;if(ce){let Ie=ds[ce];de=Ie.vertexShader,Q=Ie.fragmentShader}else{de=y.vertexShader,Q=y.fragmentShader;let Ie=a.getVertexShaderStage(y),ct=a.getFragmentShaderStage(y);a.update(y,Ie,ct),ge=Ie.id,xe=ct.id}let Pe=i.getRenderTarget(),we=i.state.buffers.depth.getReversed(),Xe=L.isInstancedMesh===!0,at=L.isBatchedMesh===!0,$e=!!y.map,mt=!!y.matcap,dt=!!z,st=dt&&z.isPMREMTexture===!0,Zt=!!y.aoMap,Ht=!!y.lightMap,hn=!!y.bumpMap&&y.wireframe===!1,kt=!!y.normalMap,Cn=!!y.displacementMap,wt=!!y.emissiveMap,yn=!!y.metalnessMap,tn=!!y.roughnessMap,un=y.anisotropy>0,k=y.clearcoat>0,Le=y.diffuseRoughness>0,Ke=y.dispersion>0,lt=y.retroreflectivity>0,Ee=y.iridescence>0,zt=y.sheen>0,We=y.transmission>0,je=un&&!!y.anisotropyMap,R=k&&!!y.clearcoatMap,w=k&&!!y.clearcoatNormalMap,$=k&&!!y.clearcoatRoughnessMap,he=Le&&!!y.diffuseRoughnessMap,oe=Ee&&!!y.iridescenceMap,ye=Ee&&!!y.iridescenceThicknessMap,ve=zt&&!!y.sheenColorMap,ee=zt&&!!y.sheenRoughnessMap,ne=!!y.specularMap,me=!!y.specularColorMap,F=!!y.specularIntensityMap,se=We&&!!y.transmissionMap,te=We&&!!y.thicknessMap,Te=!!y.gradientMap,_e=!!y.alphaMap,Me=y.alphaTest>0,qe=!!y.alphaHash,et=!!y.extensions,le=hs;y.toneMapped&&(Pe===null||Pe.isXRRenderTarget===!0)&&(le=i.toneMapping);let ze=st?z.isCompressedCubeTexture?z.image[0].mipmaps:z.mipmaps:null,tt={shaderID:ce,shaderType:y.type,shaderName:y.name,vertexShader:de,fragmentShader:Q,defines:y.defines,customVertexShaderID:ge,customFragmentShaderID:xe,isRawShaderMaterial:y.isRawShaderMaterial===!0,glslVersion:y.glslVersion,precision:Z,batching:at,batchingColor:at&&L._colorsTexture!==null,instancing:Xe,instancingColor:Xe&&L.instanceColor!==null,instancingMorph:Xe&&L.morphTexture!==null,outputColorSpace:Pe===null?i.outputColorSpace:Pe.isXRRenderTarget===!0?Pe.texture.colorSpace:St.workingColorSpace,alphaToCoverage:!!y.alphaToCoverage,map:$e,matcap:mt,envMap:dt,envMapMode:dt&&z.mapping,envMapPMREM:st,envMapMaxLod:st?ze.length-1:null,envMapSize:st?ze[0].width:null,aoMap:Zt,lightMap:Ht,bumpMap:hn,normalMap:kt,displacementMap:Cn,emissiveMap:wt,normalMapObjectSpace:kt&&y.normalMapType===Fx,normalMapTangentSpace:kt&&y.normalMapType===Xu,packedNormalMap:kt&&y.normalMapType===Xu&&WR(y.normalMap.format),metalnessMap:yn,roughnessMap:tn,anisotropy:un,anisotropyMap:je,clearcoat:k,clearcoatMap:R,clearcoatNormalMap:w,clearcoatRoughnessMap:$,diffuseRoughness:Le,diffuseRoughnessMap:he,dispersion:Ke,retroreflection:lt,iridescence:Ee,iridescenceMap:oe,iridescenceThicknessMap:ye,sheen:zt,sheenColorMap:ve,sheenRoughnessMap:ee,specularMap:ne,specularColorMap:me,specularIntensityMap:F,transmission:We,transmissionMap:se,thicknessMap:te,gradientMap:Te,opaque:y.transparent===!1&&y.blending===dr&&y.alphaToCoverage===!1,alphaMap:_e,alphaTest:Me,alphaHash:qe,combine:y.combine,mapUv:$e&&f(y.map.channel),aoMapUv:Zt&&f(y.aoMap.channel),lightMapUv:Ht&&f(y.lightMap.channel),bumpMapUv:hn&&f(y.bumpMap.channel),normalMapUv:kt&&f(y.normalMap.channel),displacementMapUv:Cn&&f(y.displacementMap.channel),emissiveMapUv:wt&&f(y.emissiveMap.channel),metalnessMapUv:yn&&f(y.metalnessMap.channel),roughnessMapUv:tn&&f(y.roughnessMap.channel),anisotropyMapUv:je&&f(y.anisotropyMap.channel),clearcoatMapUv:R&&f(y.clearcoatMap.channel),clearcoatNormalMapUv:w&&f(y.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:$&&f(y.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:he&&f(y.diffuseRoughnessMap.channel),iridescenceMapUv:oe&&f(y.iridescenceMap.channel),iridescenceThicknessMapUv:ye&&f(y.iridescenceThicknessMap.channel),sheenColorMapUv:ve&&f(y.sheenColorMap.channel),sheenRoughnessMapUv:ee&&f(y.sheenRoughnessMap.channel),specularMapUv:ne&&f(y.specularMap.channel),specularColorMapUv:me&&f(y.specularColorMap.channel),specularIntensityMapUv:F&&f(y.specularIntensityMap.channel),transmissionMapUv:se&&f(y.transmissionMap.channel),thicknessMapUv:te&&f(y.thicknessMap.channel),alphaMapUv:_e&&f(y.alphaMap.channel),vertexTangents:!!O.attributes.tangent&&(kt||un),vertexNormals:!!O.attributes.normal,vertexColors:y.vertexColors,vertexAlphas:y.vertexColors===!0&&!!O.attributes.color&&O.attributes.color.itemSize===4,pointsUvs:L.isPoints===!0&&!!O.attributes.uv&&($e||_e),fog:!!W,useFog:y.fog===!0,fogExp2:!!W&&W.isFogExp2,flatShading:y.wireframe===!1&&(y.flatShading===!0||O.attributes.normal===void 0&&kt===!1&&(y.isMeshLambertMaterial||y.isMeshPhongMaterial||y.isMeshStandardMaterial||y.isMeshPhysicalMaterial)),sizeAttenuation:y.sizeAttenuation===!0,logarithmicDepthBuffer:u,reversedDepthBuffer:we,skinning:L.isSkinnedMesh===!0,hasPositionAttribute:O.attributes.position!==void 0,morphTargets:O.morphAttributes.position!==void 0,morphNormals:O.morphAttributes.normal!==void 0,morphColors:O.morphAttributes.color!==void 0,morphTargetsCount:ie,morphTextureStride:fe,numSunLights:M.sun.length,numDirLights:M.directional.length,numPointLights:M.point.length,numSpotLights:M.spot.length,numSpotLightMaps:M.spotLightMap.length,numRectAreaLights:M.rectArea.length,numHemiLights:M.hemi.length,numSunLightShadows:M.sunShadowMap.length,numDirLightShadows:M.directionalShadowMap.length,numPointLightShadows:M.pointShadowMap.length,numSpotLightShadows:M.spotShadowMap.length,numSpotLightShadowsWithMaps:M.numSpotLightShadowsWithMaps,numLightProbes:M.numLightProbes,numLightProbeGrids:V.filter(Ie=>Ie.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:y.dithering,shadowMapEnabled:i.shadowMap.enabled&&U.length>0,shadowMapType:i.shadowMap.type,toneMapping:le,decodeVideoTexture:$e&&y.map.isVideoTexture===!0&&St.getTransfer(y.map.colorSpace)===Dt,decodeVideoTextureEmissive:wt&&y.emissiveMap.isVideoTexture===!0&&St.getTransfer(y.emissiveMap.colorSpace)===Dt,premultipliedAlpha:y.premultipliedAlpha,doubleSided:y.side===Pi,flipSided:y.side===Qn,useDepthPacking:y.depthPacking>=0,depthPacking:y.depthPacking||0,index0AttributeName:y.index0AttributeName,extensionClipCullDistance:et&&y.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(et&&y.extensions.multiDraw===!0||at)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:y.customProgramCacheKey()};return tt.vertexUv1s=l.has(1),tt.vertexUv2s=l.has(2),tt.vertexUv3s=l.has(3),l.clear(),tt}function _(y){let M=[];if(y.shaderID?M.push(y.shaderID):(M.push(y.customVertexShaderID),M.push(y.customFragmentShaderID)),y.defines!==void 0)for(let U in y.defines)M.push(U),M.push(y.defines[U]);return y.isRawShaderMaterial===!1&&(m(M,y),g(M,y),M.push(i.outputColorSpace)),M.push(y.customProgramCacheKey),M.join()}function m(y,M){y.push(M.precision),y.push(M.outputColorSpace),y.push(M.envMapMode),y.push(M.envMapPMREM),y.push(M.envMapMaxLod),y.push(M.envMapSize),y.push(M.mapUv),y.push(M.alphaMapUv),y.push(M.lightMapUv),y.push(M.aoMapUv),y.push(M.bumpMapUv),y.push(M.normalMapUv),y.push(M.displacementMapUv),y.push(M.emissiveMapUv),y.push(M.metalnessMapUv),y.push(M.roughnessMapUv),y.push(M.anisotropyMapUv),y.push(M.clearcoatMapUv),y.push(M.clearcoatNormalMapUv),y.push(M.clearcoatRoughnessMapUv),y.push(M.diffuseRoughnessMapUv),y.push(M.iridescenceMapUv),y.push(M.iridescenceThicknessMapUv),y.push(M.sheenColorMapUv),y.push(M.sheenRoughnessMapUv),y.push(M.specularMapUv),y.push(M.specularColorMapUv),y.push(M.specularIntensityMapUv),y.push(M.transmissionMapUv),y.push(M.thicknessMapUv),y.push(M.combine),y.push(M.fogExp2),y.push(M.sizeAttenuation),y.push(M.morphTargetsCount),y.push(M.numSunLights),y.push(M.numDirLights),y.push(M.numPointLights),y.push(M.numSpotLights),y.push(M.numSpotLightMaps),y.push(M.numHemiLights),y.push(M.numRectAreaLights),y.push(M.numSunLightShadows),y.push(M.numDirLightShadows),y.push(M.numPointLightShadows),y.push(M.numSpotLightShadows),y.push(M.numSpotLightShadowsWithMaps),y.push(M.numLightProbes),y.push(M.numLightProbeGrids),y.push(M.shadowMapType),y.push(M.toneMapping),y.push(M.numClippingPlanes),y.push(M.numClipIntersection),y.push(M.depthPacking)}function g(y,M){o.disableAll(),M.instancing&&o.enable(0),M.instancingColor&&o.enable(1),M.instancingMorph&&o.enable(2),M.matcap&&o.enable(3),M.envMap&&o.enable(4),M.normalMapObjectSpace&&o.enable(5),M.normalMapTangentSpace&&o.enable(6),M.clearcoat&&o.enable(7),M.iridescence&&o.enable(8),M.alphaTest&&o.enable(9),M.vertexColors&&o.enable(10),M.vertexAlphas&&o.enable(11),M.vertexUv1s&&o.enable(12),M.vertexUv2s&&o.enable(13),M.vertexUv3s&&o.enable(14),M.vertexTangents&&o.enable(15),M.anisotropy&&o.enable(16),M.alphaHash&&o.enable(17),M.batching&&o.enable(18),M.dispersion&&o.enable(19),M.retroreflection&&o.enable(24),M.diffuseRoughness&&o.enable(25),M.batchingColor&&o.enable(20),M.gradientMap&&o.enable(21),M.packedNormalMap&&o.enable(22),M.vertexNormals&&o.enable(23),y.push(o.mask),o.disableAll(),M.fog&&o.enable(0),M.useFog&&o.enable(1),M.flatShading&&o.enable(2),M.logarithmicDepthBuffer&&o.enable(3),M.reversedDepthBuffer&&o.enable(4),M.skinning&&o.enable(5),M.morphTargets&&o.enable(6),M.morphNormals&&o.enable(7),M.morphColors&&o.enable(8),M.premultipliedAlpha&&o.enable(9),M.shadowMapEnabled&&o.enable(10),M.doubleSided&&o.enable(11),M.flipSided&&o.enable(12),M.useDepthPacking&&o.enable(13),M.dithering&&o.enable(14),M.transmission&&o.enable(15),M.sheen&&o.enable(16),M.opaque&&o.enable(17),M.pointsUvs&&o.enable(18),M.decodeVideoTexture&&o.enable(19),M.decodeVideoTextureEmissive&&o.enable(20),M.alphaToCoverage&&o.enable(21),M.numLightProbeGrids>0&&o.enable(22),M.hasPositionAttribute&&o.enable(23),y.push(o.mask)}function x(y){let M=d[y.type],U;if(M){let N=ds[M];U=Zx.clone(N.uniforms)}else U=y.uniforms;return U}function C(y,M){let U=h.get(M);return U!==void 0?++U.usedTimes:(U=new GR(i,M,y,s),c.push(U),h.set(M,U)),U}function b(y){if(--y.usedTimes===0){let M=c.indexOf(y);c[M]=c[c.length-1],c.pop(),h.delete(y.cacheKey),y.destroy()}}function A(y){a.remove(y)}function S(){a.dispose()}return{getParameters:p,getProgramCacheKey:_,getUniforms:x,acquireProgram:C,releaseProgram:b,releaseShaderCache:A,programs:c,dispose:S}}function qR(){let i=new WeakMap;function e(o){return i.has(o)}function t(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:e,get:t,remove:n,update:s,dispose:r}}function XR(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==e.material.id?i.material.id-e.material.id:i.materialVariant!==e.materialVariant?i.materialVariant-e.materialVariant:i.z!==e.z?i.z-e.z:i.id-e.id}function gv(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}function _v(){let i=[],e=0,t=[],n=[],s=[];function r(){e=0,t.length=0,n.length=0,s.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,p,_,m,g){let x=i[e];return x===void 0?(x={id:d.id,object:d,geometry:f,material:p,materialVariant:o(d),groupOrder:_,renderOrder:d.renderOrder,z:m,group:g},i[e]=x):(x.id=d.id,x.object=d,x.geometry=f,x.material=p,x.materialVariant=o(d),x.groupOrder=_,x.renderOrder=d.renderOrder,x.z=m,x.group=g),e++,x}function l(d,f,p,_,m,g,x){x.reversedDepth===!0&&(m=-m);let C=a(d,f,p,_,m,g);p.transmission>0?n.push(C):p.transparent===!0?s.push(C):t.push(C)}function c(d,f,p,_,m,g){let x=a(d,f,p,_,m,g);p.transmission>0?n.unshift(x):p.transparent===!0?s.unshift(x):t.unshift(x)}function h(d,f){t.length>1&&t.sort(d||XR),n.length>1&&n.sort(f||gv),s.length>1&&s.sort(f||gv)}function u(){for(let d=e,f=i.length;d<f;d++){let p=i[d];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:t,transmissive:n,transparent:s,init:r,push:l,unshift:c,finish:u,sort:h}}function YR(){let i=new WeakMap;function e(n,s){let r=i.get(n),o;return r===void 0?(o=new _v,i.set(n,[o])):s>=r.length?(o=new _v,r.push(o)):o=r[s],o}function t(){i=new WeakMap}return{get:e,dispose:t}}function jR(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new I,color:new ot};break;case"SpotLight":t={position:new I,direction:new I,color:new ot,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new I,color:new ot,distance:0,decay:0};break;case"HemisphereLight":t={direction:new I,skyColor:new ot,groundColor:new ot};break;case"RectAreaLight":t={color:new ot,position:new I,halfWidth:new I,halfHeight:new I};break}return i[e.id]=t,t}}}function ZR(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Se};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Se};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Se,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.id]=t,t}}}var KR=0;function JR(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}function QR(i){let e=new jR,t=ZR(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new I);let s=new I,r=new yt,o=new yt;function a(c){let h=0,u=0,d=0;for(let V=0;V<9;V++)n.probe[V].set(0,0,0);let f=0,p=0,_=0,m=0,g=0,x=0,C=0,b=0,A=0,S=0,y=0,M=0,U=0,N=0;c.sort(JR);for(let V=0,W=c.length;V<W;V++){let O=c[V],G=O.color,j=O.intensity,z=O.distance,ce=null;if(O.shadow&&O.shadow.map&&(O.shadow.map.texture.format===fr?ce=O.shadow.map.texture:ce=O.shadow.map.depthTexture||O.shadow.map.texture),O.isAmbientLight)h+=G.r*j,u+=G.g*j,d+=G.b*j;else if(O.isLightProbe){for(let Z=0;Z<9;Z++)n.probe[Z].addScaledVector(O.sh.coefficients[Z],j);N++}else if(O.isSunLight){let Z=e.get(O);if(Z.color.copy(O.color).multiplyScalar(O.intensity),O.castShadow){let J=O.shadow,ie=t.get(O);ie.shadowIntensity=J.intensity,ie.shadowBias=J.bias,ie.shadowNormalBias=J.normalBias,ie.shadowRadius=J.radius,ie.shadowMapSize.copy(J.mapSize).multiply(J.getFrameExtents()),n.sunShadow[p]=ie,n.sunShadowMap[p]=ce;let fe=J.getViewportCount();for(let de=0;de<fe;de++)n.sunShadowMatrix[_+de]=J.getMatrix(de),n.sunShadowCascade[_+de]=J._cascadeData[de];_+=fe,p++}n.sun[f]=Z,f++}else if(O.isDirectionalLight){let Z=e.get(O);if(Z.color.copy(O.color).multiplyScalar(O.intensity),O.castShadow){let J=O.shadow,ie=t.get(O);ie.shadowIntensity=J.intensity,ie.shadowBias=J.bias,ie.shadowNormalBias=J.normalBias,ie.shadowRadius=J.radius,ie.shadowMapSize=J.mapSize,n.directionalShadow[m]=ie,n.directionalShadowMap[m]=ce,n.directionalShadowMatrix[m]=O.shadow.matrix,A++}n.directional[m]=Z,m++}else if(O.isSpotLight){let Z=e.get(O);Z.position.setFromMatrixPosition(O.matrixWorld),Z.color.copy(G).multiplyScalar(j),Z.distance=z,Z.coneCos=Math.cos(O.angle),Z.penumbraCos=Math.cos(O.angle*(1-O.penumbra)),Z.decay=O.decay,n.spot[x]=Z;let J=O.shadow;if(O.map&&(n.spotLightMap[M]=O.map,M++,J.updateMatrices(O),O.castShadow&&U++),n.spotLightMatrix[x]=J.matrix,O.castShadow){let ie=t.get(O);ie.shadowIntensity=J.intensity,ie.shadowBias=J.bias,ie.shadowNormalBias=J.normalBias,ie.shadowRadius=J.radius,ie.shadowMapSize=J.mapSize,n.spotShadow[x]=ie,n.spotShadowMap[x]=ce,y++}x++}else if(O.isRectAreaLight){let Z=e.get(O);Z.color.copy(G).multiplyScalar(j),Z.halfWidth.set(O.width*.5,0,0),Z.halfHeight.set(0,O.height*.5,0),n.rectArea[C]=Z,C++}else if(O.isPointLight){let Z=e.get(O);if(Z.color.copy(O.color).multiplyScalar(O.intensity),Z.distance=O.distance,Z.decay=O.decay,O.castShadow){let J=O.shadow,ie=t.get(O);ie.shadowIntensity=J.intensity,ie.shadowBias=J.bias,ie.shadowNormalBias=J.normalBias,ie.shadowRadius=J.radius,ie.shadowMapSize=J.mapSize,ie.shadowCameraNear=J.camera.near,ie.shadowCameraFar=J.camera.far,n.pointShadow[g]=ie,n.pointShadowMap[g]=ce,n.pointShadowMatrix[g]=O.shadow.matrix,S++}n.point[g]=Z,g++}else if(O.isHemisphereLight){let Z=e.get(O);Z.skyColor.copy(O.color).multiplyScalar(j),Z.groundColor.copy(O.groundColor).multiplyScalar(j),n.hemi[b]=Z,b++}}C>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Oe.LTC_FLOAT_1,n.rectAreaLTC2=Oe.LTC_FLOAT_2):(n.rectAreaLTC1=Oe.LTC_HALF_1,n.rectAreaLTC2=Oe.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=u,n.ambient[2]=d;let L=n.hash;(L.sunLength!==f||L.directionalLength!==m||L.pointLength!==g||L.spotLength!==x||L.rectAreaLength!==C||L.hemiLength!==b||L.numSunShadows!==p||L.numDirectionalShadows!==A||L.numPointShadows!==S||L.numSpotShadows!==y||L.numSpotMaps!==M||L.numLightProbes!==N)&&(n.sun.length=f,n.directional.length=m,n.spot.length=x,n.rectArea.length=C,n.point.length=g,n.hemi.length=b,n.sunShadow.length=p,n.sunShadowMap.length=p,n.sunShadowMatrix.length=_,n.sunShadowCascade.length=_,n.directionalShadow.length=A,n.directionalShadowMap.length=A,n.directionalShadowMatrix.length=A,n.pointShadow.length=S,n.pointShadowMap.length=S,n.pointShadowMatrix.length=S,n.spotShadow.length=y,n.spotShadowMap.length=y,n.spotLightMatrix.length=y+M-U,n.spotLightMap.length=M,n.numSpotLightShadowsWithMaps=U,n.numLightProbes=N,L.sunLength=f,L.directionalLength=m,L.pointLength=g,L.spotLength=x,L.rectAreaLength=C,L.hemiLength=b,L.numSunShadows=p,L.numDirectionalShadows=A,L.numPointShadows=S,L.numSpotShadows=y,L.numSpotMaps=M,L.numLightProbes=N,n.version=KR++)}function l(c,h){let u=0,d=0,f=0,p=0,_=0,m=0,g=h.matrixWorldInverse;for(let x=0,C=c.length;x<C;x++){let b=c[x];if(b.isSunLight){let A=n.sun[u];A.direction.setFromMatrixPosition(b.matrixWorld),A.direction.transformDirection(g),u++}else if(b.isDirectionalLight){let A=n.directional[d];A.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),A.direction.sub(s),A.direction.transformDirection(g),d++}else if(b.isSpotLight){let A=n.spot[p];A.position.setFromMatrixPosition(b.matrixWorld),A.position.applyMatrix4(g),A.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),A.direction.sub(s),A.direction.transformDirection(g),p++}else if(b.isRectAreaLight){let A=n.rectArea[_];A.position.setFromMatrixPosition(b.matrixWorld),A.position.applyMatrix4(g),o.identity(),r.copy(b.matrixWorld),r.premultiply(g),o.extractRotation(r),A.halfWidth.set(b.width*.5,0,0),A.halfHeight.set(0,b.height*.5,0),A.halfWidth.applyMatrix4(o),A.halfHeight.applyMatrix4(o),_++}else if(b.isPointLight){let A=n.point[f];A.position.setFromMatrixPosition(b.matrixWorld),A.position.applyMatrix4(g),f++}else if(b.isHemisphereLight){let A=n.hemi[m];A.direction.setFromMatrixPosition(b.matrixWorld),A.direction.transformDirection(g),m++}}}return{setup:a,setupView:l,state:n}}function yv(i){let e=new QR(i),t=[],n=[],s=[];function r(u){h.camera=u,t.length=0,n.length=0,s.length=0}function o(u){u.isLightProbeGrid?s.push(u):t.push(u)}function a(u){n.push(u)}function l(){e.setup(t),s.sort((u,d)=>u.priority-d.priority||u.id-d.id)}function c(u){e.setupView(t,u)}let h={lightsArray:t,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function eP(i){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new yv(i),e.set(s,[a])):r>=o.length?(a=new yv(i),o.push(a)):a=o[r],a}function n(){e=new WeakMap}return{get:t,dispose:n}}var tP=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,nP=`uniform sampler2D shadow_pass;
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
}`,iP=[new I(1,0,0),new I(-1,0,0),new I(0,1,0),new I(0,-1,0),new I(0,0,1),new I(0,0,-1)],sP=[new I(0,-1,0),new I(0,-1,0),new I(0,0,1),new I(0,0,-1),new I(0,-1,0),new I(0,-1,0)],xv=new yt,Nl=new I,sm=new I;function rP(i,e,t){let n=new sr,s=new Se,r=new Se,o=new Jt,a=new Yh,l=new jh,c={},h=t.maxTextureSize,u={[ur]:Qn,[Qn]:ur,[Pi]:Pi},d=new cs({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Se},radius:{value:4}},vertexShader:tP,fragmentShader:nP}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let p=new Nt;p.setAttribute("position",new yi(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let _=new Mt(p,d),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Tl;let g=this.type;this.render=function(S,y,M){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||S.length===0)return;this.type===px&&(Ze("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Tl);let U=i.getRenderTarget(),N=i.getActiveCubeFace(),L=i.getActiveMipmapLevel(),V=i.state;V.setBlending(Os),V.buffers.depth.getReversed()===!0?V.buffers.color.setClear(0,0,0,0):V.buffers.color.setClear(1,1,1,1),V.buffers.depth.setTest(!0),V.setScissorTest(!1);let W=g!==this.type;W&&y.traverse(function(O){O.material&&(Array.isArray(O.material)?O.material.forEach(G=>G.needsUpdate=!0):O.material.needsUpdate=!0)});for(let O=0,G=S.length;O<G;O++){let j=S[O],z=j.shadow;if(z===void 0){Ze("WebGLShadowMap:",j,"has no shadow.");continue}if(z.autoUpdate===!1&&z.needsUpdate===!1)continue;s.copy(z.mapSize);let ce=z.getFrameExtents();s.multiply(ce),r.copy(z.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/ce.x),s.x=r.x*ce.x,z.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/ce.y),s.y=r.y*ce.y,z.mapSize.y=r.y));let Z=i.state.buffers.depth.getReversed();if(z.camera._reversedDepth=Z,z.map===null||W===!0){if(z.map!==null&&(z.map.depthTexture!==null&&(z.map.depthTexture.dispose(),z.map.depthTexture=null),z.map.dispose()),this.type===Jo){if(j.isPointLight){Ze("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}z.map=new xi(s.x,s.y,{format:fr,type:Xi,minFilter:Kn,magFilter:Kn,generateMipmaps:!1}),z.map.texture.name=j.name+".shadowMap",z.map.depthTexture=new Ds(s.x,s.y,qi),z.map.depthTexture.name=j.name+".shadowMapDepth",z.map.depthTexture.format=Ps,z.map.depthTexture.compareFunction=null,z.map.depthTexture.minFilter=On,z.map.depthTexture.magFilter=On}else j.isPointLight?(z.map=new Ul(s.x),z.map.depthTexture=new cl(s.x,$i)):(z.map=new xi(s.x,s.y),z.map.depthTexture=new Ds(s.x,s.y,$i)),z.map.depthTexture.name=j.name+".shadowMap",z.map.depthTexture.format=Ps,this.type===Tl?(z.map.depthTexture.compareFunction=Z?Hp:Gp,z.map.depthTexture.minFilter=Kn,z.map.depthTexture.magFilter=Kn):(z.map.depthTexture.compareFunction=null,z.map.depthTexture.minFilter=On,z.map.depthTexture.magFilter=On);z.camera.updateProjectionMatrix()}z.map.isWebGLCubeRenderTarget!==!0&&(z.map.width!==s.x||z.map.height!==s.y)&&z.map.setSize(s.x,s.y);let J=z.map.isWebGLCubeRenderTarget?6:z.getViewportCount();j.isPointLight!==!0&&z.updateMatrices(j,M);let ie=(z.camera.layers.mask&4294967294)!==0?z.camera.layers:M.layers;for(let fe=0;fe<J;fe++){let de=z.getCamera(fe);if(j.isPointLight){let Q=z.camera,ge=z.matrix,xe=j.distance||Q.far;xe!==Q.far&&(Q.far=xe,Q.updateProjectionMatrix()),Nl.setFromMatrixPosition(j.matrixWorld),Q.position.copy(Nl),sm.copy(Q.position),sm.add(iP[fe]),Q.up.copy(sP[fe]),Q.lookAt(sm),Q.updateMatrixWorld(),ge.makeTranslation(-Nl.x,-Nl.y,-Nl.z),xv.multiplyMatrices(Q.projectionMatrix,Q.matrixWorldInverse),z._frustum.setFromProjectionMatrix(xv,Q.coordinateSystem,Q.reversedDepth)}if(z.map.isWebGLCubeRenderTarget)i.setRenderTarget(z.map,fe),i.clear();else{fe===0&&(i.setRenderTarget(z.map),i.clear());let Q=z.getViewport(fe);o.set(r.x*Q.x,r.y*Q.y,r.x*Q.z,r.y*Q.w),V.viewport(o)}n=z.getFrustum(fe),b(y,M,de,j,ie,this.type)}z.isPointLightShadow!==!0&&this.type===Jo&&x(z,M),z.needsUpdate=!1}g=this.type,m.needsUpdate=!1,i.setRenderTarget(U,N,L)};function x(S,y){let M=e.update(_);d.defines.VSM_SAMPLES!==S.blurSamples&&(d.defines.VSM_SAMPLES=S.blurSamples,f.defines.VSM_SAMPLES=S.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),S.mapPass===null?S.mapPass=new xi(s.x,s.y,{format:fr,type:Xi}):(S.mapPass.width!==S.map.width||S.mapPass.height!==S.map.height)&&S.mapPass.setSize(S.map.width,S.map.height),d.uniforms.shadow_pass.value=S.map.depthTexture,d.uniforms.resolution.value.set(S.map.width,S.map.height),d.uniforms.radius.value=S.radius,i.setRenderTarget(S.mapPass),i.clear(),i.renderBufferDirect(y,null,M,d,_,null),f.uniforms.shadow_pass.value=S.mapPass.texture,f.uniforms.resolution.value.set(S.map.width,S.map.height),f.uniforms.radius.value=S.radius,i.setRenderTarget(S.map),i.clear(),i.renderBufferDirect(y,null,M,f,_,null)}function C(S,y,M,U){let N=null,L=M.isPointLight===!0?S.customDistanceMaterial:S.customDepthMaterial;if(L!==void 0)N=L;else if(N=M.isPointLight===!0?l:a,i.localClippingEnabled&&y.clipShadows===!0&&Array.isArray(y.clippingPlanes)&&y.clippingPlanes.length!==0||y.displacementMap&&y.displacementScale!==0||y.alphaMap&&y.alphaTest>0||y.map&&y.alphaTest>0||y.alphaToCoverage===!0){let V=N.uuid,W=y.uuid,O=c[V];O===void 0&&(O={},c[V]=O);let G=O[W];G===void 0&&(G=N.clone(),O[W]=G,y.addEventListener("dispose",A)),N=G}if(N.visible=y.visible,N.wireframe=y.wireframe,U===Jo?N.side=y.shadowSide!==null?y.shadowSide:y.side:N.side=y.shadowSide!==null?y.shadowSide:u[y.side],N.alphaMap=y.alphaMap,N.alphaTest=y.alphaToCoverage===!0?.5:y.alphaTest,N.map=y.map,N.clipShadows=y.clipShadows,N.clippingPlanes=y.clippingPlanes,N.clipIntersection=y.clipIntersection,N.displacementMap=y.displacementMap,N.displacementScale=y.displacementScale,N.displacementBias=y.displacementBias,N.wireframeLinewidth=y.wireframeLinewidth,N.linewidth=y.linewidth,M.isPointLight===!0&&N.isMeshDistanceMaterial===!0){let V=i.properties.get(N);V.light=M}return N}function b(S,y,M,U,N,L){if(S.visible===!1)return;if(S.layers.test(N)&&(S.isMesh||S.isLine||S.isPoints)&&(S.castShadow||S.receiveShadow&&L===Jo)&&(!S.frustumCulled||S.intersectsFrustum(n))){S.modelViewMatrix.multiplyMatrices(M.matrixWorldInverse,S.matrixWorld);let O=e.update(S),G=S.material;if(Array.isArray(G)){let j=O.groups;for(let z=0,ce=j.length;z<ce;z++){let Z=j[z],J=G[Z.materialIndex];if(J&&J.visible){let ie=C(S,J,U,L);S.onBeforeShadow(i,S,y,M,O,ie,Z),i.renderBufferDirect(M,null,O,ie,S,Z),S.onAfterShadow(i,S,y,M,O,ie,Z)}}}else if(G.visible){let j=C(S,G,U,L);S.onBeforeShadow(i,S,y,M,O,j,null),i.renderBufferDirect(M,null,O,j,S,null),S.onAfterShadow(i,S,y,M,O,j,null)}}let W=S.children;for(let O=0,G=W.length;O<G;O++)b(W[O],y,M,U,N,L)}function A(S){S.target.removeEventListener("dispose",A);for(let M in c){let U=c[M],N=S.target.uuid;N in U&&(U[N].dispose(),delete U[N])}}}function oP(i,e){function t(){let F=!1,se=new Jt,te=null,Te=new Jt(0,0,0,0);return{setMask:function(_e){te!==_e&&!F&&(i.colorMask(_e,_e,_e,_e),te=_e)},setLocked:function(_e){F=_e},setClear:function(_e,Me,qe,et,le){le===!0&&(_e*=et,Me*=et,qe*=et),se.set(_e,Me,qe,et),Te.equals(se)===!1&&(i.clearColor(_e,Me,qe,et),Te.copy(se))},reset:function(){F=!1,te=null,Te.set(-1,0,0,0)}}}function n(){let F=!1,se=!1,te=null,Te=null,_e=null;return{setReversed:function(Me){if(se!==Me){let qe=e.get("EXT_clip_control");Me?qe.clipControlEXT(qe.LOWER_LEFT_EXT,qe.ZERO_TO_ONE_EXT):qe.clipControlEXT(qe.LOWER_LEFT_EXT,qe.NEGATIVE_ONE_TO_ONE_EXT),se=Me;let et=_e;_e=null,this.setClear(et)}},getReversed:function(){return se},setTest:function(Me){Me?we(i.DEPTH_TEST):Xe(i.DEPTH_TEST)},setMask:function(Me){te!==Me&&!F&&(i.depthMask(Me),te=Me)},setFunc:function(Me){if(se&&(Me=Xx[Me]),Te!==Me){switch(Me){case bh:i.depthFunc(i.NEVER);break;case Sh:i.depthFunc(i.ALWAYS);break;case Mh:i.depthFunc(i.LESS);break;case ko:i.depthFunc(i.LEQUAL);break;case wh:i.depthFunc(i.EQUAL);break;case Eh:i.depthFunc(i.GEQUAL);break;case Th:i.depthFunc(i.GREATER);break;case Ah:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}Te=Me}},setLocked:function(Me){F=Me},setClear:function(Me){_e!==Me&&(_e=Me,se&&(Me=1-Me),i.clearDepth(Me))},reset:function(){F=!1,te=null,Te=null,_e=null,se=!1}}}function s(){let F=!1,se=null,te=null,Te=null,_e=null,Me=null,qe=null,et=null,le=null;return{setTest:function(ze){F||(ze?we(i.STENCIL_TEST):Xe(i.STENCIL_TEST))},setMask:function(ze){se!==ze&&!F&&(i.stencilMask(ze),se=ze)},setFunc:function(ze,tt,Ie){(te!==ze||Te!==tt||_e!==Ie)&&(i.stencilFunc(ze,tt,Ie),te=ze,Te=tt,_e=Ie)},setOp:function(ze,tt,Ie){(Me!==ze||qe!==tt||et!==Ie)&&(i.stencilOp(ze,tt,Ie),Me=ze,qe=tt,et=Ie)},setLocked:function(ze){F=ze},setClear:function(ze){le!==ze&&(i.clearStencil(ze),le=ze)},reset:function(){F=!1,se=null,te=null,Te=null,_e=null,Me=null,qe=null,et=null,le=null}}}let r=new t,o=new n,a=new s,l={},c=new WeakMap,h={},u={},d={},f=new WeakMap,p=[],_=null,m=!1,g=null,x=null,C=null,b=null,A=null,S=null,y=null,M=new ot(0,0,0),U=0,N=!1,L=null,V=null,W=null,O=null,G=null,j=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),z=!1,ce=0,Z=i.getParameter(i.VERSION);Z.indexOf("WebGL")!==-1?(ce=parseFloat(/^WebGL (\d)/.exec(Z)[1]),z=ce>=1):Z.indexOf("OpenGL ES")!==-1&&(ce=parseFloat(/^OpenGL ES (\d)/.exec(Z)[1]),z=ce>=2);let J=null,ie={},fe=i.getParameter(i.SCISSOR_BOX),de=i.getParameter(i.VIEWPORT),Q=new Jt().fromArray(fe),ge=new Jt().fromArray(de);function xe(F,se,te,Te){let _e=new Uint8Array(4),Me=i.createTexture();i.bindTexture(F,Me),i.texParameteri(F,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(F,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let qe=0;qe<te;qe++)F===i.TEXTURE_3D||F===i.TEXTURE_2D_ARRAY?i.texImage3D(se,0,i.RGBA,1,1,Te,0,i.RGBA,i.UNSIGNED_BYTE,_e):i.texImage2D(se+qe,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,_e);return Me}let Pe={};Pe[i.TEXTURE_2D]=xe(i.TEXTURE_2D,i.TEXTURE_2D,1),Pe[i.TEXTURE_CUBE_MAP]=xe(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),Pe[i.TEXTURE_2D_ARRAY]=xe(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Pe[i.TEXTURE_3D]=xe(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),we(i.DEPTH_TEST),o.setFunc(ko),hn(!1),kt(bp),we(i.CULL_FACE),Zt(Os);function we(F){h[F]!==!0&&(i.enable(F),h[F]=!0)}function Xe(F){h[F]!==!1&&(i.disable(F),h[F]=!1)}function at(F,se){return d[F]!==se?(i.bindFramebuffer(F,se),d[F]=se,F===i.DRAW_FRAMEBUFFER&&(d[i.FRAMEBUFFER]=se),F===i.FRAMEBUFFER&&(d[i.DRAW_FRAMEBUFFER]=se),!0):!1}function $e(F,se){let te=p,Te=!1;if(F){te=f.get(se),te===void 0&&(te=[],f.set(se,te));let _e=F.textures;if(te.length!==_e.length||te[0]!==i.COLOR_ATTACHMENT0){for(let Me=0,qe=_e.length;Me<qe;Me++)te[Me]=i.COLOR_ATTACHMENT0+Me;te.length=_e.length,Te=!0}}else te[0]!==i.BACK&&(te[0]=i.BACK,Te=!0);Te&&i.drawBuffers(te)}function mt(F){return _!==F?(i.useProgram(F),_=F,!0):!1}let dt={[Br]:i.FUNC_ADD,[gx]:i.FUNC_SUBTRACT,[_x]:i.FUNC_REVERSE_SUBTRACT};dt[yx]=i.MIN,dt[xx]=i.MAX;let st={[vx]:i.ZERO,[bx]:i.ONE,[Sx]:i.SRC_COLOR,[Ep]:i.SRC_ALPHA,[Cx]:i.SRC_ALPHA_SATURATE,[Tx]:i.DST_COLOR,[wx]:i.DST_ALPHA,[Mx]:i.ONE_MINUS_SRC_COLOR,[Tp]:i.ONE_MINUS_SRC_ALPHA,[Ax]:i.ONE_MINUS_DST_COLOR,[Ex]:i.ONE_MINUS_DST_ALPHA,[Rx]:i.CONSTANT_COLOR,[Px]:i.ONE_MINUS_CONSTANT_COLOR,[Ix]:i.CONSTANT_ALPHA,[Lx]:i.ONE_MINUS_CONSTANT_ALPHA};function Zt(F,se,te,Te,_e,Me,qe,et,le,ze){if(F===Os){m===!0&&(Xe(i.BLEND),m=!1);return}if(m===!1&&(we(i.BLEND),m=!0),F!==mx){if(F!==g||ze!==N){if((x!==Br||A!==Br)&&(i.blendEquation(i.FUNC_ADD),x=Br,A=Br),ze)switch(F){case dr:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Sp:i.blendFunc(i.ONE,i.ONE);break;case Mp:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case wp:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:Qe("WebGLState: Invalid blending: ",F);break}else switch(F){case dr:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Sp:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case Mp:Qe("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case wp:Qe("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:Qe("WebGLState: Invalid blending: ",F);break}C=null,b=null,S=null,y=null,M.set(0,0,0),U=0,g=F,N=ze}return}_e=_e||se,Me=Me||te,qe=qe||Te,(se!==x||_e!==A)&&(i.blendEquationSeparate(dt[se],dt[_e]),x=se,A=_e),(te!==C||Te!==b||Me!==S||qe!==y)&&(i.blendFuncSeparate(st[te],st[Te],st[Me],st[qe]),C=te,b=Te,S=Me,y=qe),(et.equals(M)===!1||le!==U)&&(i.blendColor(et.r,et.g,et.b,le),M.copy(et),U=le),g=F,N=!1}function Ht(F,se){F.side===Pi?Xe(i.CULL_FACE):we(i.CULL_FACE);let te=F.side===Qn;se&&(te=!te),hn(te),F.blending===dr&&F.transparent===!1?Zt(Os):Zt(F.blending,F.blendEquation,F.blendSrc,F.blendDst,F.blendEquationAlpha,F.blendSrcAlpha,F.blendDstAlpha,F.blendColor,F.blendAlpha,F.premultipliedAlpha),o.setFunc(F.depthFunc),o.setTest(F.depthTest),o.setMask(F.depthWrite),r.setMask(F.colorWrite);let Te=F.stencilWrite;a.setTest(Te),Te&&(a.setMask(F.stencilWriteMask),a.setFunc(F.stencilFunc,F.stencilRef,F.stencilFuncMask),a.setOp(F.stencilFail,F.stencilZFail,F.stencilZPass)),wt(F.polygonOffset,F.polygonOffsetFactor,F.polygonOffsetUnits),F.alphaToCoverage===!0?we(i.SAMPLE_ALPHA_TO_COVERAGE):Xe(i.SAMPLE_ALPHA_TO_COVERAGE)}function hn(F){L!==F&&(F?i.frontFace(i.CW):i.frontFace(i.CCW),L=F)}function kt(F){F!==dx?(we(i.CULL_FACE),F!==V&&(F===bp?i.cullFace(i.BACK):F===fx?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Xe(i.CULL_FACE),V=F}function Cn(F){F!==W&&(z&&i.lineWidth(F),W=F)}function wt(F,se,te){F?(we(i.POLYGON_OFFSET_FILL),(O!==se||G!==te)&&(O=se,G=te,o.getReversed()&&(se=-se,te=-te),i.polygonOffset(se,te))):Xe(i.POLYGON_OFFSET_FILL)}function yn(F){F?we(i.SCISSOR_TEST):Xe(i.SCISSOR_TEST)}function tn(F){F===void 0&&(F=i.TEXTURE0+j-1),J!==F&&(i.activeTexture(F),J=F)}function un(F,se,te){te===void 0&&(J===null?te=i.TEXTURE0+j-1:te=J);let Te=ie[te];Te===void 0&&(Te={type:void 0,texture:void 0},ie[te]=Te),(Te.type!==F||Te.texture!==se)&&(J!==te&&(i.activeTexture(te),J=te),i.bindTexture(F,se||Pe[F]),Te.type=F,Te.texture=se)}function k(){let F=ie[J];F!==void 0&&F.type!==void 0&&(i.bindTexture(F.type,null),F.type=void 0,F.texture=void 0)}function Le(){try{i.compressedTexImage2D(...arguments)}catch(F){Qe("WebGLState:",F)}}function Ke(){try{i.compressedTexImage3D(...arguments)}catch(F){Qe("WebGLState:",F)}}function lt(){try{i.texSubImage2D(...arguments)}catch(F){Qe("WebGLState:",F)}}function Ee(){try{i.texSubImage3D(...arguments)}catch(F){Qe("WebGLState:",F)}}function zt(){try{i.compressedTexSubImage2D(...arguments)}catch(F){Qe("WebGLState:",F)}}function We(){try{i.compressedTexSubImage3D(...arguments)}catch(F){Qe("WebGLState:",F)}}function je(){try{i.texStorage2D(...arguments)}catch(F){Qe("WebGLState:",F)}}function R(){try{i.texStorage3D(...arguments)}catch(F){Qe("WebGLState:",F)}}function w(){try{i.texImage2D(...arguments)}catch(F){Qe("WebGLState:",F)}}function $(){try{i.texImage3D(...arguments)}catch(F){Qe("WebGLState:",F)}}function he(F){return u[F]!==void 0?u[F]:i.getParameter(F)}function oe(F,se){u[F]!==se&&(i.pixelStorei(F,se),u[F]=se)}function ye(F){Q.equals(F)===!1&&(i.scissor(F.x,F.y,F.z,F.w),Q.copy(F))}function ve(F){ge.equals(F)===!1&&(i.viewport(F.x,F.y,F.z,F.w),ge.copy(F))}function ee(F,se){let te=c.get(se);te===void 0&&(te=new WeakMap,c.set(se,te));let Te=te.get(F);Te===void 0&&(Te=i.getUniformBlockIndex(se,F.name),i.uniformBlockBinding(se,Te,Te),te.set(F,Te))}function ne(F,se,te){let _e=c.get(se).get(F);l[_e]!==te&&(i.bindBufferBase(i.UNIFORM_BUFFER,_e,te),l[_e]=te)}function me(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),h={},u={},J=null,ie={},d={},l={},f=new WeakMap,p=[],_=null,m=!1,g=null,x=null,C=null,b=null,A=null,S=null,y=null,M=new ot(0,0,0),U=0,N=!1,L=null,V=null,W=null,O=null,G=null,Q.set(0,0,i.canvas.width,i.canvas.height),ge.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:we,disable:Xe,bindFramebuffer:at,drawBuffers:$e,useProgram:mt,setBlending:Zt,setMaterial:Ht,setFlipSided:hn,setCullFace:kt,setLineWidth:Cn,setPolygonOffset:wt,setScissorTest:yn,activeTexture:tn,bindTexture:un,unbindTexture:k,compressedTexImage2D:Le,compressedTexImage3D:Ke,texImage2D:w,texImage3D:$,pixelStorei:oe,getParameter:he,updateUBOMapping:ee,uniformBlockBinding:ne,texStorage2D:je,texStorage3D:R,texSubImage2D:lt,texSubImage3D:Ee,compressedTexSubImage2D:zt,compressedTexSubImage3D:We,scissor:ye,viewport:ve,reset:me}}function aP(i,e,t,n,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Se,h=new WeakMap,u=new Set,d,f=new WeakMap,p=new Set,_=new FinalizationRegistry(R=>p.delete(R)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(R,w){return m?new OffscreenCanvas(R,w):el("canvas")}function x(R,w,$){let he=1,oe=je(R);if((oe.width>$||oe.height>$)&&(he=$/Math.max(oe.width,oe.height)),he<1)if(typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&R instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&R instanceof ImageBitmap||typeof VideoFrame<"u"&&R instanceof VideoFrame){let ye=Math.floor(he*oe.width),ve=Math.floor(he*oe.height);d===void 0&&(d=g(ye,ve));let ee=w?g(ye,ve):d;return ee.width=ye,ee.height=ve,ee.getContext("2d").drawImage(R,0,0,ye,ve),Ze("WebGLRenderer: Texture has been resized from ("+oe.width+"x"+oe.height+") to ("+ye+"x"+ve+")."),ee}else return"data"in R&&Ze("WebGLRenderer: Image in DataTexture is too big ("+oe.width+"x"+oe.height+")."),R;return R}function C(R){return R.generateMipmaps}function b(R){i.generateMipmap(R)}function A(R){return R.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:R.isWebGL3DRenderTarget?i.TEXTURE_3D:R.isWebGLArrayRenderTarget||R.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function S(R,w,$,he,oe,ye=!1){if(R!==null){if(i[R]!==void 0)return i[R];Ze("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+R+"'")}let ve;he&&(ve=e.get("EXT_texture_norm16"),ve||Ze("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let ee=w;if(w===i.RED&&($===i.FLOAT&&(ee=i.R32F),$===i.HALF_FLOAT&&(ee=i.R16F),$===i.UNSIGNED_BYTE&&(ee=i.R8),$===i.UNSIGNED_SHORT&&ve&&(ee=ve.R16_EXT),$===i.SHORT&&ve&&(ee=ve.R16_SNORM_EXT)),w===i.RED_INTEGER&&($===i.UNSIGNED_BYTE&&(ee=i.R8UI),$===i.UNSIGNED_SHORT&&(ee=i.R16UI),$===i.UNSIGNED_INT&&(ee=i.R32UI),$===i.BYTE&&(ee=i.R8I),$===i.SHORT&&(ee=i.R16I),$===i.INT&&(ee=i.R32I)),w===i.RG&&($===i.FLOAT&&(ee=i.RG32F),$===i.HALF_FLOAT&&(ee=i.RG16F),$===i.UNSIGNED_BYTE&&(ee=i.RG8),$===i.UNSIGNED_SHORT&&ve&&(ee=ve.RG16_EXT),$===i.SHORT&&ve&&(ee=ve.RG16_SNORM_EXT)),w===i.RG_INTEGER&&($===i.UNSIGNED_BYTE&&(ee=i.RG8UI),$===i.UNSIGNED_SHORT&&(ee=i.RG16UI),$===i.UNSIGNED_INT&&(ee=i.RG32UI),$===i.BYTE&&(ee=i.RG8I),$===i.SHORT&&(ee=i.RG16I),$===i.INT&&(ee=i.RG32I)),w===i.RGB_INTEGER&&($===i.UNSIGNED_BYTE&&(ee=i.RGB8UI),$===i.UNSIGNED_SHORT&&(ee=i.RGB16UI),$===i.UNSIGNED_INT&&(ee=i.RGB32UI),$===i.BYTE&&(ee=i.RGB8I),$===i.SHORT&&(ee=i.RGB16I),$===i.INT&&(ee=i.RGB32I)),w===i.RGBA_INTEGER&&($===i.UNSIGNED_BYTE&&(ee=i.RGBA8UI),$===i.UNSIGNED_SHORT&&(ee=i.RGBA16UI),$===i.UNSIGNED_INT&&(ee=i.RGBA32UI),$===i.BYTE&&(ee=i.RGBA8I),$===i.SHORT&&(ee=i.RGBA16I),$===i.INT&&(ee=i.RGBA32I)),w===i.RGB&&($===i.UNSIGNED_SHORT&&ve&&(ee=ve.RGB16_EXT),$===i.SHORT&&ve&&(ee=ve.RGB16_SNORM_EXT),$===i.UNSIGNED_INT_5_9_9_9_REV&&(ee=i.RGB9_E5),$===i.UNSIGNED_INT_10F_11F_11F_REV&&(ee=i.R11F_G11F_B10F)),w===i.RGBA){let ne=ye?Qa:St.getTransfer(oe);$===i.FLOAT&&(ee=i.RGBA32F),$===i.HALF_FLOAT&&(ee=i.RGBA16F),$===i.UNSIGNED_BYTE&&(ee=ne===Dt?i.SRGB8_ALPHA8:i.RGBA8),$===i.UNSIGNED_SHORT&&ve&&(ee=ve.RGBA16_EXT),$===i.SHORT&&ve&&(ee=ve.RGBA16_SNORM_EXT),$===i.UNSIGNED_SHORT_4_4_4_4&&(ee=i.RGBA4),$===i.UNSIGNED_SHORT_5_5_5_1&&(ee=i.RGB5_A1)}return(ee===i.R16F||ee===i.R32F||ee===i.RG16F||ee===i.RG32F||ee===i.RGBA16F||ee===i.RGBA32F)&&e.get("EXT_color_buffer_float"),ee}function y(R,w){let $;return R?w===null||w===$i||w===Vr?$=i.DEPTH24_STENCIL8:w===qi?$=i.DEPTH32F_STENCIL8:w===ta&&($=i.DEPTH24_STENCIL8,Ze("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):w===null||w===$i||w===Vr?$=i.DEPTH_COMPONENT24:w===qi?$=i.DEPTH_COMPONENT32F:w===ta&&($=i.DEPTH_COMPONENT16),$}function M(R,w){return C(R)===!0||R.isFramebufferTexture&&R.minFilter!==On&&R.minFilter!==Kn?Math.log2(Math.max(w.width,w.height))+1:R.mipmaps.length>0?R.mipmaps.length:R.isCompressedTexture&&Array.isArray(R.image)?w.mipmaps.length:1}function U(R){let w=new WeakRef(R);n.get(R).__ref=w,p.add(w),_.register(R,w,w)}function N(R){let w=n.get(R).__ref;w!==void 0&&(p.delete(w),_.unregister(w))}function L(R){W(R.target)}function V(R){O(R.target)}function W(R){R.removeEventListener("dispose",L),N(R),j(R),R.isVideoTexture&&h.delete(R),R.isHTMLTexture&&u.delete(R)}function O(R){R.removeEventListener("dispose",V),N(R),ce(R)}function G(){for(let R of p){let w=R.deref();w!==void 0&&(w.isRenderTarget===!0?O(w):W(w))}p.clear(),u.clear()}function j(R){let w=n.get(R);if(w.__webglInit===void 0)return;let $=R.source,he=f.get($);if(he){let oe=he[w.__cacheKey];oe.usedTimes--,oe.usedTimes===0&&z(R),Object.keys(he).length===0&&f.delete($)}n.remove(R)}function z(R){let w=n.get(R);i.deleteTexture(w.__webglTexture);let $=R.source,he=f.get($);delete he[w.__cacheKey],o.memory.textures--}function ce(R){let w=n.get(R);w.__depthDisposeCallback&&w.__depthDisposeCallback();let $=R.depthTexture;if($&&$.renderTarget===R&&W($),R.isWebGLCubeRenderTarget)for(let oe=0;oe<6;oe++){if(Array.isArray(w.__webglFramebuffer[oe]))for(let ye=0;ye<w.__webglFramebuffer[oe].length;ye++)i.deleteFramebuffer(w.__webglFramebuffer[oe][ye]);else i.deleteFramebuffer(w.__webglFramebuffer[oe]);w.__webglDepthbuffer&&i.deleteRenderbuffer(w.__webglDepthbuffer[oe])}else{if(Array.isArray(w.__webglFramebuffer))for(let oe=0;oe<w.__webglFramebuffer.length;oe++)i.deleteFramebuffer(w.__webglFramebuffer[oe]);else i.deleteFramebuffer(w.__webglFramebuffer);if(w.__webglDepthbuffer&&i.deleteRenderbuffer(w.__webglDepthbuffer),w.__webglMultisampledFramebuffer&&i.deleteFramebuffer(w.__webglMultisampledFramebuffer),w.__webglColorRenderbuffer)for(let oe=0;oe<w.__webglColorRenderbuffer.length;oe++)w.__webglColorRenderbuffer[oe]&&i.deleteRenderbuffer(w.__webglColorRenderbuffer[oe]);w.__webglDepthRenderbuffer&&i.deleteRenderbuffer(w.__webglDepthRenderbuffer)}let he=R.textures;for(let oe=0,ye=he.length;oe<ye;oe++){let ve=n.get(he[oe]);ve.__webglTexture&&(i.deleteTexture(ve.__webglTexture),o.memory.textures--),n.remove(he[oe])}n.remove(R)}let Z=0;function J(){Z=0}function ie(){return Z}function fe(R){Z=R}function de(){let R=Z;return R>=s.maxTextures&&Ze("WebGLTextures: Trying to use "+(R+1)+" texture units while this GPU supports only "+s.maxTextures),Z+=1,R}function Q(R){let w=[];return w.push(R.wrapS),w.push(R.wrapT),w.push(R.wrapR||0),w.push(R.magFilter),w.push(R.minFilter),w.push(R.anisotropy),w.push(R.internalFormat),w.push(R.format),w.push(R.type),w.push(R.generateMipmaps),w.push(R.mipmapsAutoUpdate),w.push(R.premultiplyAlpha),w.push(R.flipY),w.push(R.unpackAlignment),w.push(R.colorSpace),w.join()}function ge(R,w){let $=n.get(R);if(R.isVideoTexture&&zt(R),R.isRenderTargetTexture===!1&&R.isExternalTexture!==!0&&R.version>0&&$.__version!==R.version){let he=R.image;if(he===null)Ze("WebGLRenderer: Texture marked for update but no image data found.");else if(he.complete===!1)Ze("WebGLRenderer: Texture marked for update but image is incomplete");else{Ht($,R,w);return}}else R.isExternalTexture&&($.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(i.TEXTURE_2D,$.__webglTexture,i.TEXTURE0+w)}function xe(R,w){let $=n.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&$.__version!==R.version){Ht($,R,w);return}else R.isExternalTexture&&($.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(i.TEXTURE_2D_ARRAY,$.__webglTexture,i.TEXTURE0+w)}function Pe(R,w){let $=n.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&$.__version!==R.version){Ht($,R,w);return}t.bindTexture(i.TEXTURE_3D,$.__webglTexture,i.TEXTURE0+w)}function we(R,w){let $=n.get(R);if(R.version>0&&$.__version!==R.version){hn($,R,w);return}t.bindTexture(i.TEXTURE_CUBE_MAP,$.__webglTexture,i.TEXTURE0+w)}let Xe={[Ch]:i.REPEAT,[as]:i.CLAMP_TO_EDGE,[Rh]:i.MIRRORED_REPEAT},at={[On]:i.NEAREST,[Ox]:i.NEAREST_MIPMAP_NEAREST,[Al]:i.NEAREST_MIPMAP_LINEAR,[Kn]:i.LINEAR,[hu]:i.LINEAR_MIPMAP_NEAREST,[Us]:i.LINEAR_MIPMAP_LINEAR},$e={[Bx]:i.NEVER,[Wp]:i.ALWAYS,[zx]:i.LESS,[Gp]:i.LEQUAL,[Vx]:i.EQUAL,[Hp]:i.GEQUAL,[Gx]:i.GREATER,[Hx]:i.NOTEQUAL};function mt(R,w){if(w.type===qi&&e.has("OES_texture_float_linear")===!1&&(w.magFilter===Kn||w.magFilter===hu||w.magFilter===Al||w.magFilter===Us||w.minFilter===Kn||w.minFilter===hu||w.minFilter===Al||w.minFilter===Us)&&Ze("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(R,i.TEXTURE_WRAP_S,Xe[w.wrapS]),i.texParameteri(R,i.TEXTURE_WRAP_T,Xe[w.wrapT]),(R===i.TEXTURE_3D||R===i.TEXTURE_2D_ARRAY)&&i.texParameteri(R,i.TEXTURE_WRAP_R,Xe[w.wrapR]),i.texParameteri(R,i.TEXTURE_MAG_FILTER,at[w.magFilter]),i.texParameteri(R,i.TEXTURE_MIN_FILTER,at[w.minFilter]),w.compareFunction&&(i.texParameteri(R,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(R,i.TEXTURE_COMPARE_FUNC,$e[w.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(w.magFilter===On||w.minFilter!==Al&&w.minFilter!==Us||w.type===qi&&e.has("OES_texture_float_linear")===!1)return;if(w.anisotropy>1||n.get(w).__currentAnisotropy){let $=e.get("EXT_texture_filter_anisotropic");i.texParameterf(R,$.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(w.anisotropy,s.getMaxAnisotropy())),n.get(w).__currentAnisotropy=w.anisotropy}}}function dt(R,w){let $=!1;R.__webglInit===void 0&&(R.__webglInit=!0,w.addEventListener("dispose",L),U(w));let he=w.source,oe=f.get(he);oe===void 0&&(oe={},f.set(he,oe));let ye=Q(w);if(ye!==R.__cacheKey){oe[ye]===void 0&&(oe[ye]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,$=!0),oe[ye].usedTimes++;let ve=oe[R.__cacheKey];ve!==void 0&&(oe[R.__cacheKey].usedTimes--,ve.usedTimes===0&&z(w)),R.__cacheKey=ye,R.__webglTexture=oe[ye].texture}return $}function st(R,w,$){return Math.floor(Math.floor(R/$)/w)}function Zt(R,w,$,he){let ye=R.updateRanges;if(ye.length===0)t.texSubImage2D(i.TEXTURE_2D,0,0,0,w.width,w.height,$,he,w.data);else{ye.sort((F,se)=>F.start-se.start);let ve=0;for(let F=1;F<ye.length;F++){let se=ye[ve],te=ye[F],Te=se.start+se.count,_e=st(te.start,w.width,4),Me=st(se.start,w.width,4);te.start<=Te+1&&_e===Me&&st(te.start+te.count-1,w.width,4)===_e?se.count=Math.max(se.count,te.start+te.count-se.start):(++ve,ye[ve]=te)}ye.length=ve+1;let ee=t.getParameter(i.UNPACK_ROW_LENGTH),ne=t.getParameter(i.UNPACK_SKIP_PIXELS),me=t.getParameter(i.UNPACK_SKIP_ROWS);t.pixelStorei(i.UNPACK_ROW_LENGTH,w.width);for(let F=0,se=ye.length;F<se;F++){let te=ye[F],Te=Math.floor(te.start/4),_e=Math.ceil(te.count/4),Me=Te%w.width,qe=Math.floor(Te/w.width),et=_e,le=1;t.pixelStorei(i.UNPACK_SKIP_PIXELS,Me),t.pixelStorei(i.UNPACK_SKIP_ROWS,qe),t.texSubImage2D(i.TEXTURE_2D,0,Me,qe,et,le,$,he,w.data)}R.clearUpdateRanges(),t.pixelStorei(i.UNPACK_ROW_LENGTH,ee),t.pixelStorei(i.UNPACK_SKIP_PIXELS,ne),t.pixelStorei(i.UNPACK_SKIP_ROWS,me)}}function Ht(R,w,$){let he=i.TEXTURE_2D;(w.isDataArrayTexture||w.isCompressedArrayTexture)&&(he=i.TEXTURE_2D_ARRAY),w.isData3DTexture&&(he=i.TEXTURE_3D);let oe=dt(R,w),ye=w.source;t.bindTexture(he,R.__webglTexture,i.TEXTURE0+$);let ve=n.get(ye);if(ye.version!==ve.__version||oe===!0){if(t.activeTexture(i.TEXTURE0+$),(typeof ImageBitmap<"u"&&w.image instanceof ImageBitmap)===!1){let le=St.getPrimaries(St.workingColorSpace),ze=w.colorSpace===ks?null:St.getPrimaries(w.colorSpace),tt=w.colorSpace===ks||le===ze?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,w.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,tt)}t.pixelStorei(i.UNPACK_ALIGNMENT,w.unpackAlignment);let ne=x(w.image,!1,s.maxTextureSize);ne=We(w,ne);let me=r.convert(w.format,w.colorSpace),F=r.convert(w.type),se=S(w.internalFormat,me,F,w.normalized,w.colorSpace,w.isVideoTexture);mt(he,w);let te,Te=w.mipmaps,_e=w.isVideoTexture!==!0,Me=ve.__version===void 0||oe===!0,qe=ye.dataReady,et=M(w,ne);if(w.isDepthTexture)se=y(w.format===Fs,w.type),Me&&(_e?t.texStorage2D(i.TEXTURE_2D,1,se,ne.width,ne.height):t.texImage2D(i.TEXTURE_2D,0,se,ne.width,ne.height,0,me,F,null));else if(w.isDataTexture)if(Te.length>0){_e&&Me&&t.texStorage2D(i.TEXTURE_2D,et,se,Te[0].width,Te[0].height);for(let le=0,ze=Te.length;le<ze;le++)te=Te[le],_e?qe&&t.texSubImage2D(i.TEXTURE_2D,le,0,0,te.width,te.height,me,F,te.data):t.texImage2D(i.TEXTURE_2D,le,se,te.width,te.height,0,me,F,te.data);w.generateMipmaps=!1}else _e?(Me&&t.texStorage2D(i.TEXTURE_2D,et,se,ne.width,ne.height),qe&&Zt(w,ne,me,F)):t.texImage2D(i.TEXTURE_2D,0,se,ne.width,ne.height,0,me,F,ne.data);else if(w.isCompressedTexture)if(w.isCompressedArrayTexture){_e&&Me&&t.texStorage3D(i.TEXTURE_2D_ARRAY,et,se,Te[0].width,Te[0].height,ne.depth);for(let le=0,ze=Te.length;le<ze;le++)if(te=Te[le],w.format!==Yi)if(me!==null)if(_e){if(qe)if(w.layerUpdates.size>0){let tt=nm(te.width,te.height,w.format,w.type);for(let Ie of w.layerUpdates){let ct=te.data.subarray(Ie*tt/te.data.BYTES_PER_ELEMENT,(Ie+1)*tt/te.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,le,0,0,Ie,te.width,te.height,1,me,ct)}}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,le,0,0,0,te.width,te.height,ne.depth,me,te.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,le,se,te.width,te.height,ne.depth,0,te.data,0,0);else Ze("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else _e?qe&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,le,0,0,0,te.width,te.height,ne.depth,me,F,te.data):t.texImage3D(i.TEXTURE_2D_ARRAY,le,se,te.width,te.height,ne.depth,0,me,F,te.data);w.layerUpdates.size>0&&w.clearLayerUpdates()}else{_e&&Me&&t.texStorage2D(i.TEXTURE_2D,et,se,Te[0].width,Te[0].height);for(let le=0,ze=Te.length;le<ze;le++)te=Te[le],w.format!==Yi?me!==null?_e?qe&&t.compressedTexSubImage2D(i.TEXTURE_2D,le,0,0,te.width,te.height,me,te.data):t.compressedTexImage2D(i.TEXTURE_2D,le,se,te.width,te.height,0,te.data):Ze("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):_e?qe&&t.texSubImage2D(i.TEXTURE_2D,le,0,0,te.width,te.height,me,F,te.data):t.texImage2D(i.TEXTURE_2D,le,se,te.width,te.height,0,me,F,te.data)}else if(w.isDataArrayTexture)if(_e){if(Me&&t.texStorage3D(i.TEXTURE_2D_ARRAY,et,se,ne.width,ne.height,ne.depth),qe)if(w.layerUpdates.size>0){let le=nm(ne.width,ne.height,w.format,w.type);for(let ze of w.layerUpdates){let tt=ne.data.subarray(ze*le/ne.data.BYTES_PER_ELEMENT,(ze+1)*le/ne.data.BYTES_PER_ELEMENT);t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,ze,ne.width,ne.height,1,me,F,tt)}w.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,ne.width,ne.height,ne.depth,me,F,ne.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,se,ne.width,ne.height,ne.depth,0,me,F,ne.data);else if(w.isData3DTexture)_e?(Me&&t.texStorage3D(i.TEXTURE_3D,et,se,ne.width,ne.height,ne.depth),qe&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,ne.width,ne.height,ne.depth,me,F,ne.data)):t.texImage3D(i.TEXTURE_3D,0,se,ne.width,ne.height,ne.depth,0,me,F,ne.data);else if(w.isFramebufferTexture){if(Me)if(_e)t.texStorage2D(i.TEXTURE_2D,et,se,ne.width,ne.height);else{let le=ne.width,ze=ne.height;for(let tt=0;tt<et;tt++)t.texImage2D(i.TEXTURE_2D,tt,se,le,ze,0,me,F,null),le>>=1,ze>>=1}}else if(w.isHTMLTexture){if("texElementImage2D"in i){let le=i.canvas;if(le.hasAttribute("layoutsubtree")||le.setAttribute("layoutsubtree","true"),ne.parentNode!==le){le.appendChild(ne),u.add(w),le.onpaint=ze=>{let tt=ze.changedElements;for(let Ie of u)tt.includes(Ie.image)&&(Ie.needsUpdate=!0)},le.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,ne);else{let tt=i.RGBA,Ie=i.RGBA,ct=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,tt,Ie,ct,ne)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(Te.length>0){if(_e&&Me){let le=je(Te[0]);t.texStorage2D(i.TEXTURE_2D,et,se,le.width,le.height)}for(let le=0,ze=Te.length;le<ze;le++)te=Te[le],_e?qe&&t.texSubImage2D(i.TEXTURE_2D,le,0,0,me,F,te):t.texImage2D(i.TEXTURE_2D,le,se,me,F,te);w.generateMipmaps=!1}else if(_e){if(Me){let le=je(ne);t.texStorage2D(i.TEXTURE_2D,et,se,le.width,le.height)}qe&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,me,F,ne)}else t.texImage2D(i.TEXTURE_2D,0,se,me,F,ne);C(w)&&w.mipmapsAutoUpdate===!0&&b(he),ve.__version=ye.version,w.onUpdate&&w.onUpdate(w)}R.__version=w.version}function hn(R,w,$){if(w.image.length!==6)return;let he=dt(R,w),oe=w.source;t.bindTexture(i.TEXTURE_CUBE_MAP,R.__webglTexture,i.TEXTURE0+$);let ye=n.get(oe);if(oe.version!==ye.__version||he===!0){t.activeTexture(i.TEXTURE0+$);let ve=St.getPrimaries(St.workingColorSpace),ee=w.colorSpace===ks?null:St.getPrimaries(w.colorSpace),ne=w.colorSpace===ks||ve===ee?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,w.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),t.pixelStorei(i.UNPACK_ALIGNMENT,w.unpackAlignment),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,ne);let me=w.isCompressedTexture||w.image[0].isCompressedTexture,F=w.image[0]&&w.image[0].isDataTexture,se=[];for(let Ie=0;Ie<6;Ie++)!me&&!F?se[Ie]=x(w.image[Ie],!0,s.maxCubemapSize):se[Ie]=F?w.image[Ie].image:w.image[Ie],se[Ie]=We(w,se[Ie]);let te=se[0],Te=r.convert(w.format,w.colorSpace),_e=r.convert(w.type),Me=S(w.internalFormat,Te,_e,w.normalized,w.colorSpace),qe=w.isVideoTexture!==!0,et=ye.__version===void 0||he===!0,le=oe.dataReady,ze=M(w,te);mt(i.TEXTURE_CUBE_MAP,w);let tt;if(w.isDepthTexture){if(Me=y(w.format===Fs,w.type),et)if(qe)t.texStorage2D(i.TEXTURE_CUBE_MAP,1,Me,te.width,te.height);else for(let Ie=0;Ie<6;Ie++)t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,0,Me,te.width,te.height,0,Te,_e,null)}else if(me){qe&&et&&t.texStorage2D(i.TEXTURE_CUBE_MAP,ze,Me,te.width,te.height);for(let Ie=0;Ie<6;Ie++){tt=se[Ie].mipmaps;for(let ct=0;ct<tt.length;ct++){let Wt=tt[ct];w.format!==Yi?Te!==null?qe?le&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,ct,0,0,Wt.width,Wt.height,Te,Wt.data):t.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,ct,Me,Wt.width,Wt.height,0,Wt.data):Ze("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):qe?le&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,ct,0,0,Wt.width,Wt.height,Te,_e,Wt.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,ct,Me,Wt.width,Wt.height,0,Te,_e,Wt.data)}}}else{if(tt=w.mipmaps,qe&&et){tt.length>0&&ze++;let Ie=je(se[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,ze,Me,Ie.width,Ie.height)}for(let Ie=0;Ie<6;Ie++)if(F){qe?le&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,0,0,0,se[Ie].width,se[Ie].height,Te,_e,se[Ie].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,0,Me,se[Ie].width,se[Ie].height,0,Te,_e,se[Ie].data);for(let ct=0;ct<tt.length;ct++){let Gn=tt[ct].image[Ie].image;qe?le&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,ct+1,0,0,Gn.width,Gn.height,Te,_e,Gn.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,ct+1,Me,Gn.width,Gn.height,0,Te,_e,Gn.data)}}else{qe?le&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,0,0,0,Te,_e,se[Ie]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,0,Me,Te,_e,se[Ie]);for(let ct=0;ct<tt.length;ct++){let Wt=tt[ct];qe?le&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,ct+1,0,0,Te,_e,Wt.image[Ie]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,ct+1,Me,Te,_e,Wt.image[Ie])}}}C(w)&&w.mipmapsAutoUpdate===!0&&b(i.TEXTURE_CUBE_MAP),ye.__version=oe.version,w.onUpdate&&w.onUpdate(w)}R.__version=w.version}function kt(R,w,$,he,oe,ye){let ve=r.convert($.format,$.colorSpace),ee=r.convert($.type),ne=S($.internalFormat,ve,ee,$.normalized,$.colorSpace),me=n.get(w),F=n.get($);if(F.__renderTarget=w,!me.__hasExternalTextures){let se=Math.max(1,w.width>>ye),te=Math.max(1,w.height>>ye);oe===i.TEXTURE_3D||oe===i.TEXTURE_2D_ARRAY?t.texImage3D(oe,ye,ne,se,te,w.depth,0,ve,ee,null):t.texImage2D(oe,ye,ne,se,te,0,ve,ee,null)}t.bindFramebuffer(i.FRAMEBUFFER,R),Ee(w)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,he,oe,F.__webglTexture,0,lt(w)):(oe===i.TEXTURE_2D||oe>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&oe<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,he,oe,F.__webglTexture,ye),t.bindFramebuffer(i.FRAMEBUFFER,null)}function Cn(R,w,$){if(i.bindRenderbuffer(i.RENDERBUFFER,R),w.depthBuffer){let he=w.depthTexture,oe=he&&he.isDepthTexture?he.type:null,ye=y(w.stencilBuffer,oe),ve=w.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;Ee(w)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,lt(w),ye,w.width,w.height):$?i.renderbufferStorageMultisample(i.RENDERBUFFER,lt(w),ye,w.width,w.height):i.renderbufferStorage(i.RENDERBUFFER,ye,w.width,w.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,ve,i.RENDERBUFFER,R)}else{let he=w.textures;for(let oe=0;oe<he.length;oe++){let ye=he[oe],ve=r.convert(ye.format,ye.colorSpace),ee=r.convert(ye.type),ne=S(ye.internalFormat,ve,ee,ye.normalized,ye.colorSpace);Ee(w)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,lt(w),ne,w.width,w.height):$?i.renderbufferStorageMultisample(i.RENDERBUFFER,lt(w),ne,w.width,w.height):i.renderbufferStorage(i.RENDERBUFFER,ne,w.width,w.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function wt(R,w,$){let he=w.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(i.FRAMEBUFFER,R),!(w.depthTexture&&w.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let oe=n.get(w.depthTexture);oe.__renderTarget=w;let ye=he?w.depthTexture.image[0]:w.depthTexture.image;(!oe.__webglTexture||ye.width!==w.width||ye.height!==w.height)&&(ye.width=w.width,ye.height=w.height,w.depthTexture.needsUpdate=!0),he?we(w.depthTexture,0):ge(w.depthTexture,0);let ve=oe.__webglTexture,ee=lt(w),ne=he?i.TEXTURE_CUBE_MAP_POSITIVE_X+$:i.TEXTURE_2D,me=w.depthTexture.format===Fs?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(w.depthTexture.format===Ps)Ee(w)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,me,ne,ve,0,ee):i.framebufferTexture2D(i.FRAMEBUFFER,me,ne,ve,0);else if(w.depthTexture.format===Fs)Ee(w)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,me,ne,ve,0,ee):i.framebufferTexture2D(i.FRAMEBUFFER,me,ne,ve,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function yn(R){let w=n.get(R),$=R.isWebGLCubeRenderTarget===!0;if(w.__boundDepthTexture!==R.depthTexture){let he=R.depthTexture;if(w.__depthDisposeCallback&&w.__depthDisposeCallback(),he){let oe=()=>{delete w.__boundDepthTexture,delete w.__depthDisposeCallback,he.removeEventListener("dispose",oe)};he.addEventListener("dispose",oe),w.__depthDisposeCallback=oe}w.__boundDepthTexture=he}if(R.depthTexture&&!w.__autoAllocateDepthBuffer)if($)for(let he=0;he<6;he++)wt(w.__webglFramebuffer[he],R,he);else R.texture.mipmaps.length>0?wt(w.__webglFramebuffer[0],R,0):wt(w.__webglFramebuffer,R,0);else if($){w.__webglDepthbuffer=[];for(let he=0;he<6;he++)if(t.bindFramebuffer(i.FRAMEBUFFER,w.__webglFramebuffer[he]),w.__webglDepthbuffer[he]===void 0)w.__webglDepthbuffer[he]=i.createRenderbuffer(),Cn(w.__webglDepthbuffer[he],R,!1);else{let oe=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ye=w.__webglDepthbuffer[he];i.bindRenderbuffer(i.RENDERBUFFER,ye),i.framebufferRenderbuffer(i.FRAMEBUFFER,oe,i.RENDERBUFFER,ye)}}else if(R.texture.mipmaps.length>0?t.bindFramebuffer(i.FRAMEBUFFER,w.__webglFramebuffer[0]):t.bindFramebuffer(i.FRAMEBUFFER,w.__webglFramebuffer),w.__webglDepthbuffer===void 0)w.__webglDepthbuffer=i.createRenderbuffer(),Cn(w.__webglDepthbuffer,R,!1);else{let oe=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ye=w.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,ye),i.framebufferRenderbuffer(i.FRAMEBUFFER,oe,i.RENDERBUFFER,ye)}t.bindFramebuffer(i.FRAMEBUFFER,null)}function tn(R,w,$){let he=n.get(R);w!==void 0&&kt(he.__webglFramebuffer,R,R.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),$!==void 0&&yn(R)}function un(R){let w=R.texture,$=n.get(R),he=n.get(w);R.addEventListener("dispose",V),U(R);let oe=R.textures,ye=R.isWebGLCubeRenderTarget===!0,ve=oe.length>1;if(ve||(he.__webglTexture===void 0&&(he.__webglTexture=i.createTexture()),he.__version=w.version,o.memory.textures++),ye){$.__webglFramebuffer=[];for(let ee=0;ee<6;ee++)if(w.mipmaps.length>0){$.__webglFramebuffer[ee]=[];for(let ne=0;ne<w.mipmaps.length;ne++)$.__webglFramebuffer[ee][ne]=i.createFramebuffer()}else $.__webglFramebuffer[ee]=i.createFramebuffer()}else{if(w.mipmaps.length>0){$.__webglFramebuffer=[];for(let ee=0;ee<w.mipmaps.length;ee++)$.__webglFramebuffer[ee]=i.createFramebuffer()}else $.__webglFramebuffer=i.createFramebuffer();if(ve)for(let ee=0,ne=oe.length;ee<ne;ee++){let me=n.get(oe[ee]);me.__webglTexture===void 0&&(me.__webglTexture=i.createTexture(),o.memory.textures++)}if(R.samples>0&&Ee(R)===!1){$.__webglMultisampledFramebuffer=i.createFramebuffer(),$.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,$.__webglMultisampledFramebuffer);for(let ee=0;ee<oe.length;ee++){let ne=oe[ee];$.__webglColorRenderbuffer[ee]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,$.__webglColorRenderbuffer[ee]);let me=r.convert(ne.format,ne.colorSpace),F=r.convert(ne.type),se=S(ne.internalFormat,me,F,ne.normalized,ne.colorSpace,R.isXRRenderTarget===!0),te=lt(R);i.renderbufferStorageMultisample(i.RENDERBUFFER,te,se,R.width,R.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+ee,i.RENDERBUFFER,$.__webglColorRenderbuffer[ee])}i.bindRenderbuffer(i.RENDERBUFFER,null),R.depthBuffer&&($.__webglDepthRenderbuffer=i.createRenderbuffer(),Cn($.__webglDepthRenderbuffer,R,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(ye){t.bindTexture(i.TEXTURE_CUBE_MAP,he.__webglTexture),mt(i.TEXTURE_CUBE_MAP,w);for(let ee=0;ee<6;ee++)if(w.mipmaps.length>0)for(let ne=0;ne<w.mipmaps.length;ne++)kt($.__webglFramebuffer[ee][ne],R,w,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+ee,ne);else kt($.__webglFramebuffer[ee],R,w,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+ee,0);C(w)?b(i.TEXTURE_CUBE_MAP):w.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,w.mipmaps.length-1),t.unbindTexture()}else if(ve){for(let ee=0,ne=oe.length;ee<ne;ee++){let me=oe[ee],F=n.get(me),se=i.TEXTURE_2D;(R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(se=R.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(se,F.__webglTexture),mt(se,me),kt($.__webglFramebuffer,R,me,i.COLOR_ATTACHMENT0+ee,se,0),C(me)&&b(se)}t.unbindTexture()}else{let ee=i.TEXTURE_2D;if((R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(ee=R.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(ee,he.__webglTexture),mt(ee,w),w.mipmaps.length>0)for(let ne=0;ne<w.mipmaps.length;ne++)kt($.__webglFramebuffer[ne],R,w,i.COLOR_ATTACHMENT0,ee,ne);else kt($.__webglFramebuffer,R,w,i.COLOR_ATTACHMENT0,ee,0);C(w)?b(ee):w.mipmaps.length>0&&i.texParameteri(ee,i.TEXTURE_MAX_LEVEL,w.mipmaps.length-1),t.unbindTexture()}R.depthBuffer&&yn(R)}function k(R){let w=R.textures;for(let $=0,he=w.length;$<he;$++){let oe=w[$];if(C(oe)&&oe.mipmapsAutoUpdate===!0){let ye=A(R),ve=n.get(oe).__webglTexture;t.bindTexture(ye,ve),b(ye),t.unbindTexture()}}}let Le=[];function Ke(R){if(R.samples>0){if(Ee(R)===!1){let w=R.textures,$=R.width,he=R.height,oe=i.COLOR_BUFFER_BIT,ye=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ve=n.get(R),ee=w.length>1;if(ee)for(let me=0;me<w.length;me++)t.bindFramebuffer(i.FRAMEBUFFER,ve.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+me,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,ve.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+me,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,ve.__webglMultisampledFramebuffer),R.texture.mipmaps.length>0?t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ve.__webglFramebuffer[0]):t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ve.__webglFramebuffer);for(let me=0;me<w.length;me++){if(R.resolveDepthBuffer&&(R.depthBuffer&&(oe|=i.DEPTH_BUFFER_BIT),R.stencilBuffer&&R.resolveStencilBuffer&&(oe|=i.STENCIL_BUFFER_BIT)),ee){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,ve.__webglColorRenderbuffer[me]);let F=n.get(w[me]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,F,0)}i.blitFramebuffer(0,0,$,he,0,0,$,he,oe,i.NEAREST),l===!0&&(Le.length=0,Le.push(i.COLOR_ATTACHMENT0+me),R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&Le.push(ye),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,Le))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),ee)for(let me=0;me<w.length;me++){t.bindFramebuffer(i.FRAMEBUFFER,ve.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+me,i.RENDERBUFFER,ve.__webglColorRenderbuffer[me]);let F=n.get(w[me]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,ve.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+me,i.TEXTURE_2D,F,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ve.__webglMultisampledFramebuffer)}else if(R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&l){let w=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[w])}}}function lt(R){return Math.min(s.maxSamples,R.samples)}function Ee(R){let w=n.get(R);return R.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&w.__useRenderToTexture!==!1}function zt(R){let w=o.render.frame;h.get(R)!==w&&(h.set(R,w),R.update())}function We(R,w){let $=R.colorSpace,he=R.format,oe=R.type;return R.isCompressedTexture===!0||R.isVideoTexture===!0||$!==Ja&&$!==ks&&(St.getTransfer($)===Dt?(he!==Yi||oe!==ii)&&Ze("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):Qe("WebGLTextures: Unsupported texture color space:",$)),w}function je(R){return typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement?(c.width=R.naturalWidth||R.width,c.height=R.naturalHeight||R.height):typeof VideoFrame<"u"&&R instanceof VideoFrame?(c.width=R.displayWidth,c.height=R.displayHeight):(c.width=R.width,c.height=R.height),c}this.allocateTextureUnit=de,this.resetTextureUnits=J,this.getTextureUnits=ie,this.setTextureUnits=fe,this.setTexture2D=ge,this.setTexture2DArray=xe,this.setTexture3D=Pe,this.setTextureCube=we,this.rebindTextures=tn,this.setupRenderTarget=un,this.updateRenderTargetMipmap=k,this.updateMultisampleRenderTarget=Ke,this.setupDepthRenderbuffer=yn,this.setupFrameBufferTexture=kt,this.useMultisampledRTT=Ee,this.dispose=G}function lP(i,e){function t(n,s=ks){let r,o=St.getTransfer(s);if(n===ii)return i.UNSIGNED_BYTE;if(n===du)return i.UNSIGNED_SHORT_4_4_4_4;if(n===fu)return i.UNSIGNED_SHORT_5_5_5_1;if(n===Fp)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===kp)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===Op)return i.BYTE;if(n===Up)return i.SHORT;if(n===ta)return i.UNSIGNED_SHORT;if(n===uu)return i.INT;if(n===$i)return i.UNSIGNED_INT;if(n===qi)return i.FLOAT;if(n===Xi)return i.HALF_FLOAT;if(n===Bp)return i.ALPHA;if(n===zp)return i.RGB;if(n===Yi)return i.RGBA;if(n===Ps)return i.DEPTH_COMPONENT;if(n===Fs)return i.DEPTH_STENCIL;if(n===Vp)return i.RED;if(n===pu)return i.RED_INTEGER;if(n===fr)return i.RG;if(n===mu)return i.RG_INTEGER;if(n===gu)return i.RGBA_INTEGER;if(n===Cl||n===Rl||n===Pl||n===Il)if(o===Dt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===Cl)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===Rl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===Pl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===Il)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===Cl)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===Rl)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===Pl)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===Il)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===_u||n===yu||n===xu||n===vu)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===_u)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===yu)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===xu)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===vu)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===bu||n===Su||n===Mu||n===wu||n===Eu||n===Ll||n===Tu)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(n===bu||n===Su)return o===Dt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===Mu)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===wu)return r.COMPRESSED_R11_EAC;if(n===Eu)return r.COMPRESSED_SIGNED_R11_EAC;if(n===Ll)return r.COMPRESSED_RG11_EAC;if(n===Tu)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===Au||n===Cu||n===Ru||n===Pu||n===Iu||n===Lu||n===Du||n===Nu||n===Ou||n===Uu||n===Fu||n===ku||n===Bu||n===zu)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(n===Au)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===Cu)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===Ru)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===Pu)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===Iu)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===Lu)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===Du)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===Nu)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===Ou)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===Uu)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===Fu)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===ku)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===Bu)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===zu)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===Vu||n===Gu||n===Hu)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(n===Vu)return o===Dt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===Gu)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===Hu)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===Wu||n===$u||n===Dl||n===qu)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(n===Wu)return r.COMPRESSED_RED_RGTC1_EXT;if(n===$u)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===Dl)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===qu)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===Vr?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:t}}var cP=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,hP=`
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

}`,um=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let n=new hl(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=n}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,n=new cs({vertexShader:cP,fragmentShader:hP,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new Mt(new ml(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},dm=class extends Gi{constructor(e,t){super();let n=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,h=null,u=null,d=null,f=null,p=null,_=typeof XRWebGLBinding<"u",m=new um,g={},x=t.getContextAttributes(),C=null,b=null,A=[],S=[],y=new Se,M=null,U=null,N=new Zn;N.viewport=new Jt;let L=new Zn;L.viewport=new Jt;let V=[N,L],W=new au,O=null,G=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(Q){let ge=A[Q];return ge===void 0&&(ge=new Wo,A[Q]=ge),ge.getTargetRaySpace()},this.getControllerGrip=function(Q){let ge=A[Q];return ge===void 0&&(ge=new Wo,A[Q]=ge),ge.getGripSpace()},this.getHand=function(Q){let ge=A[Q];return ge===void 0&&(ge=new Wo,A[Q]=ge),ge.getHandSpace()};function j(Q){let ge=S.indexOf(Q.inputSource);if(ge===-1)return;let xe=A[ge];xe!==void 0&&(xe.update(Q.inputSource,Q.frame,c||o),xe.dispatchEvent({type:Q.type,data:Q.inputSource}))}function z(){s.removeEventListener("select",j),s.removeEventListener("selectstart",j),s.removeEventListener("selectend",j),s.removeEventListener("squeeze",j),s.removeEventListener("squeezestart",j),s.removeEventListener("squeezeend",j),s.removeEventListener("end",z),s.removeEventListener("inputsourceschange",ce);for(let Q=0;Q<A.length;Q++){let ge=S[Q];ge!==null&&(S[Q]=null,A[Q].disconnect(ge))}O=null,G=null,m.reset();for(let Q in g)delete g[Q];if(e.setRenderTarget(C),f=null,d=null,u=null,s=null,b=null,de.stop(),n.isPresenting=!1,e.setPixelRatio(M),e.setSize(y.width,y.height,!1),U!==null){let Q=U.camera;Q.fov=U.fov,Q.zoom=U.zoom,Q.updateProjectionMatrix(),U=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(Q){r=Q,n.isPresenting===!0&&Ze("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(Q){a=Q,n.isPresenting===!0&&Ze("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(Q){c=Q},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return u===null&&_&&(u=new XRWebGLBinding(s,t)),u},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(Q){if(s=Q,s!==null){if(C=e.getRenderTarget(),s.addEventListener("select",j),s.addEventListener("selectstart",j),s.addEventListener("selectend",j),s.addEventListener("squeeze",j),s.addEventListener("squeezestart",j),s.addEventListener("squeezeend",j),s.addEventListener("end",z),s.addEventListener("inputsourceschange",ce),x.xrCompatible!==!0&&await t.makeXRCompatible(),M=e.getPixelRatio(),e.getSize(y),_&&"createProjectionLayer"in XRWebGLBinding.prototype){let xe=null,Pe=null,we=null;x.depth&&(we=x.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,xe=x.stencil?Fs:Ps,Pe=x.stencil?Vr:$i);let Xe={colorFormat:t.RGBA8,depthFormat:we,scaleFactor:r};u=this.getBinding(),d=u.createProjectionLayer(Xe),s.updateRenderState({layers:[d]}),e.setPixelRatio(1),e.setSize(d.textureWidth,d.textureHeight,!1),b=new xi(d.textureWidth,d.textureHeight,{format:Yi,type:ii,depthTexture:new Ds(d.textureWidth,d.textureHeight,Pe,void 0,void 0,void 0,void 0,void 0,void 0,xe),stencilBuffer:x.stencil,colorSpace:e.outputColorSpace,samples:x.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let xe={antialias:x.antialias,alpha:!0,depth:x.depth,stencil:x.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,t,xe),s.updateRenderState({baseLayer:f}),e.setPixelRatio(1),e.setSize(f.framebufferWidth,f.framebufferHeight,!1),b=new xi(f.framebufferWidth,f.framebufferHeight,{format:Yi,type:ii,colorSpace:e.outputColorSpace,stencilBuffer:x.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}b.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),de.setContext(s),de.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function ce(Q){for(let ge=0;ge<Q.removed.length;ge++){let xe=Q.removed[ge],Pe=S.indexOf(xe);Pe>=0&&(S[Pe]=null,A[Pe].disconnect(xe))}for(let ge=0;ge<Q.added.length;ge++){let xe=Q.added[ge],Pe=S.indexOf(xe);if(Pe===-1){for(let Xe=0;Xe<A.length;Xe++)if(Xe>=S.length){S.push(xe),Pe=Xe;break}else if(S[Xe]===null){S[Xe]=xe,Pe=Xe;break}if(Pe===-1)break}let we=A[Pe];we&&we.connect(xe)}}function Z(Q,ge){ge===null?Q.matrixWorld.copy(Q.matrix):Q.matrixWorld.multiplyMatrices(ge.matrixWorld,Q.matrix),Q.matrixWorldInverse.copy(Q.matrixWorld).invert()}this.updateCamera=function(Q){if(s===null)return;let ge=Q.near,xe=Q.far;m.texture!==null&&(m.depthNear>0&&(ge=m.depthNear),m.depthFar>0&&(xe=m.depthFar)),W.near=L.near=N.near=ge,W.far=L.far=N.far=xe,(O!==W.near||G!==W.far)&&(s.updateRenderState({depthNear:W.near,depthFar:W.far}),O=W.near,G=W.far),W.layers.mask=Q.layers.mask|6,N.layers.mask=W.layers.mask&-5,L.layers.mask=W.layers.mask&-3;let Pe=Q.parent,we=W.cameras;Z(W,Pe);for(let Xe=0;Xe<we.length;Xe++)Z(we[Xe],Pe);W.projectionMatrix.copy(N.projectionMatrix),W.projectionMatrixInverse.copy(N.projectionMatrixInverse),U===null&&Q.isPerspectiveCamera&&(U={camera:Q,fov:Q.fov,zoom:Q.zoom}),J(Q,W,Pe)};function J(Q,ge,xe){xe===null?Q.matrix.copy(ge.matrixWorld):(Q.matrix.copy(xe.matrixWorld),Q.matrix.invert(),Q.matrix.multiply(ge.matrixWorld)),Q.matrix.decompose(Q.position,Q.quaternion,Q.scale),Q.updateMatrixWorld(!0),Q.projectionMatrix.copy(ge.projectionMatrix),Q.projectionMatrixInverse.copy(ge.projectionMatrixInverse),Q.isPerspectiveCamera&&(Q.fov=Vo*2*Math.atan(1/Q.projectionMatrix.elements[5]),Q.zoom=1)}this.getCamera=function(){return W},this.getFoveation=function(){if(!(d===null&&f===null))return l},this.setFoveation=function(Q){l=Q,d!==null&&(d.fixedFoveation=Q),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=Q)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(W)},this.getCameraTexture=function(Q){return g[Q]};let ie=null;function fe(Q,ge){if(h=ge.getViewerPose(c||o),p=ge,h!==null){let xe=h.views;f!==null&&(e.setRenderTargetFramebuffer(b,f.framebuffer),e.setRenderTarget(b));let Pe=!1;xe.length!==W.cameras.length&&(W.cameras.length=0,Pe=!0);for(let $e=0;$e<xe.length;$e++){let mt=xe[$e],dt=null;if(f!==null)dt=f.getViewport(mt);else{let Zt=u.getViewSubImage(d,mt);dt=Zt.viewport,$e===0&&(e.setRenderTargetTextures(b,Zt.colorTexture,Zt.depthStencilTexture),e.setRenderTarget(b))}let st=V[$e];st===void 0&&(st=new Zn,st.layers.enable($e),st.viewport=new Jt,V[$e]=st),st.matrix.fromArray(mt.transform.matrix),st.matrix.decompose(st.position,st.quaternion,st.scale),st.projectionMatrix.fromArray(mt.projectionMatrix),st.projectionMatrixInverse.copy(st.projectionMatrix).invert(),st.viewport.set(dt.x,dt.y,dt.width,dt.height),$e===0&&(W.matrix.copy(st.matrix),W.matrix.decompose(W.position,W.quaternion,W.scale)),Pe===!0&&W.cameras.push(st)}let we=s.enabledFeatures;if(we&&we.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&_){u=n.getBinding();let $e=u.getDepthInformation(xe[0]);$e&&$e.isValid&&$e.texture&&m.init($e,s.renderState)}if(we&&we.includes("camera-access")&&_){e.state.unbindTexture(),u=n.getBinding();for(let $e=0;$e<xe.length;$e++){let mt=xe[$e].camera;if(mt){let dt=g[mt];dt||(dt=new hl,g[mt]=dt);let st=u.getCameraImage(mt);dt.sourceTexture=st}}}}for(let xe=0;xe<A.length;xe++){let Pe=S[xe],we=A[xe];Pe!==null&&we!==void 0&&we.update(Pe,ge,c||o)}ie&&ie(Q,ge),ge.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:ge}),p=null}let de=new vv;de.setAnimationLoop(fe),this.setAnimationLoop=function(Q){ie=Q},this.dispose=function(){}}},uP=new yt,Pv=new it;Pv.set(-1,0,0,0,1,0,0,0,1);function dP(i,e){function t(m,g){m.matrixAutoUpdate===!0&&m.updateMatrix(),g.value.copy(m.matrix)}function n(m,g){g.color.getRGB(m.fogColor.value,Qp(i)),g.isFog?(m.fogNear.value=g.near,m.fogFar.value=g.far):g.isFogExp2&&(m.fogDensity.value=g.density)}function s(m,g,x,C,b){g.isNodeMaterial?g.uniformsNeedUpdate=!1:g.isMeshBasicMaterial?r(m,g):g.isMeshLambertMaterial?(r(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshToonMaterial?(r(m,g),u(m,g)):g.isMeshPhongMaterial?(r(m,g),h(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshStandardMaterial?(r(m,g),d(m,g),g.isMeshPhysicalMaterial&&f(m,g,b)):g.isMeshMatcapMaterial?(r(m,g),p(m,g)):g.isMeshDepthMaterial?r(m,g):g.isMeshDistanceMaterial?(r(m,g),_(m,g)):g.isMeshNormalMaterial?r(m,g):g.isLineBasicMaterial?(o(m,g),g.isLineDashedMaterial&&a(m,g)):g.isPointsMaterial?l(m,g,x,C):g.isSpriteMaterial?c(m,g):g.isShadowMaterial?(m.color.value.copy(g.color),m.opacity.value=g.opacity):g.isShaderMaterial&&(g.uniformsNeedUpdate=!1)}function r(m,g){m.opacity.value=g.opacity,g.color&&m.diffuse.value.copy(g.color),g.emissive&&m.emissive.value.copy(g.emissive).multiplyScalar(g.emissiveIntensity),g.map&&(m.map.value=g.map,t(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,t(g.alphaMap,m.alphaMapTransform)),g.bumpMap&&(m.bumpMap.value=g.bumpMap,t(g.bumpMap,m.bumpMapTransform),m.bumpScale.value=g.bumpScale,g.side===Qn&&(m.bumpScale.value*=-1)),g.normalMap&&(m.normalMap.value=g.normalMap,t(g.normalMap,m.normalMapTransform),m.normalScale.value.copy(g.normalScale),g.side===Qn&&m.normalScale.value.negate()),g.displacementMap&&(m.displacementMap.value=g.displacementMap,t(g.displacementMap,m.displacementMapTransform),m.displacementScale.value=g.displacementScale,m.displacementBias.value=g.displacementBias),g.emissiveMap&&(m.emissiveMap.value=g.emissiveMap,t(g.emissiveMap,m.emissiveMapTransform)),g.specularMap&&(m.specularMap.value=g.specularMap,t(g.specularMap,m.specularMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest);let x=e.get(g),C=x.envMap,b=x.envMapRotation;C&&(m.envMap.value=C,m.envMapRotation.value.setFromMatrix4(uP.makeRotationFromEuler(b)).transpose(),C.isCubeTexture&&C.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(Pv),m.reflectivity.value=g.reflectivity,m.ior.value=g.ior,m.refractionRatio.value=g.refractionRatio),g.lightMap&&(m.lightMap.value=g.lightMap,m.lightMapIntensity.value=g.lightMapIntensity,t(g.lightMap,m.lightMapTransform)),g.aoMap&&(m.aoMap.value=g.aoMap,m.aoMapIntensity.value=g.aoMapIntensity,t(g.aoMap,m.aoMapTransform))}function o(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,g.map&&(m.map.value=g.map,t(g.map,m.mapTransform))}function a(m,g){m.dashSize.value=g.dashSize,m.totalSize.value=g.dashSize+g.gapSize,m.scale.value=g.scale}function l(m,g,x,C){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.size.value=g.size*x,m.scale.value=C*.5,g.map&&(m.map.value=g.map,t(g.map,m.uvTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,t(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function c(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.rotation.value=g.rotation,g.map&&(m.map.value=g.map,t(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,t(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function h(m,g){m.specular.value.copy(g.specular),m.shininess.value=Math.max(g.shininess,1e-4)}function u(m,g){g.gradientMap&&(m.gradientMap.value=g.gradientMap)}function d(m,g){m.metalness.value=g.metalness,g.metalnessMap&&(m.metalnessMap.value=g.metalnessMap,t(g.metalnessMap,m.metalnessMapTransform)),m.roughness.value=g.roughness,g.roughnessMap&&(m.roughnessMap.value=g.roughnessMap,t(g.roughnessMap,m.roughnessMapTransform)),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)}function f(m,g,x){m.ior.value=g.ior,g.diffuseRoughness>0&&(m.diffuseRoughness.value=g.diffuseRoughness,g.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=g.diffuseRoughnessMap,t(g.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),g.sheen>0&&(m.sheenColor.value.copy(g.sheenColor).multiplyScalar(g.sheen),m.sheenRoughness.value=g.sheenRoughness,g.sheenColorMap&&(m.sheenColorMap.value=g.sheenColorMap,t(g.sheenColorMap,m.sheenColorMapTransform)),g.sheenRoughnessMap&&(m.sheenRoughnessMap.value=g.sheenRoughnessMap,t(g.sheenRoughnessMap,m.sheenRoughnessMapTransform))),g.clearcoat>0&&(m.clearcoat.value=g.clearcoat,m.clearcoatRoughness.value=g.clearcoatRoughness,g.clearcoatMap&&(m.clearcoatMap.value=g.clearcoatMap,t(g.clearcoatMap,m.clearcoatMapTransform)),g.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=g.clearcoatRoughnessMap,t(g.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),g.clearcoatNormalMap&&(m.clearcoatNormalMap.value=g.clearcoatNormalMap,t(g.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(g.clearcoatNormalScale),g.side===Qn&&m.clearcoatNormalScale.value.negate())),g.dispersion>0&&(m.dispersion.value=g.dispersion),g.retroreflectivity>0&&(m.retroreflectivity.value=g.retroreflectivity),g.iridescence>0&&(m.iridescence.value=g.iridescence,m.iridescenceIOR.value=g.iridescenceIOR,m.iridescenceThicknessMinimum.value=g.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=g.iridescenceThicknessMaximum,g.iridescenceMap&&(m.iridescenceMap.value=g.iridescenceMap,t(g.iridescenceMap,m.iridescenceMapTransform)),g.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=g.iridescenceThicknessMap,t(g.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),g.transmission>0&&(m.transmission.value=g.transmission,m.transmissionSamplerMap.value=x.texture,m.transmissionSamplerSize.value.set(x.width,x.height),g.transmissionMap&&(m.transmissionMap.value=g.transmissionMap,t(g.transmissionMap,m.transmissionMapTransform)),m.thickness.value=g.thickness,g.thicknessMap&&(m.thicknessMap.value=g.thicknessMap,t(g.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=g.attenuationDistance,m.attenuationColor.value.copy(g.attenuationColor)),g.anisotropy>0&&(m.anisotropyVector.value.set(g.anisotropy*Math.cos(g.anisotropyRotation),g.anisotropy*Math.sin(g.anisotropyRotation)),g.anisotropyMap&&(m.anisotropyMap.value=g.anisotropyMap,t(g.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=g.specularIntensity,m.specularColor.value.copy(g.specularColor),g.specularColorMap&&(m.specularColorMap.value=g.specularColorMap,t(g.specularColorMap,m.specularColorMapTransform)),g.specularIntensityMap&&(m.specularIntensityMap.value=g.specularIntensityMap,t(g.specularIntensityMap,m.specularIntensityMapTransform))}function p(m,g){g.matcap&&(m.matcap.value=g.matcap)}function _(m,g){let x=e.get(g).light;m.referencePosition.value.setFromMatrixPosition(x.matrixWorld),m.nearDistance.value=x.shadow.camera.near,m.farDistance.value=x.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function fP(i,e,t,n){let s={},r={};function o(x,C){let b=C.program;n.uniformBlockBinding(x,b,s[x.id])}function a(x,C){let b=s[x.id];b===void 0&&(p(x),b=l(x),s[x.id]=b,x.addEventListener("dispose",m));let A=C.program;n.updateUBOMapping(x,A);let S=e.render.frame;r[x.id]!==S&&(c(x),r[x.id]=S)}function l(x){let C=i.createBuffer(),b=x.__size,A=x.usage;return i.bindBuffer(i.UNIFORM_BUFFER,C),i.bufferData(i.UNIFORM_BUFFER,b,A),i.bindBuffer(i.UNIFORM_BUFFER,null),C}function c(x){let C=s[x.id],b=x.uniforms,A=x.__cache;i.bindBuffer(i.UNIFORM_BUFFER,C);for(let S=0,y=b.length;S<y;S++){let M=b[S];if(Array.isArray(M))for(let U=0,N=M.length;U<N;U++)h(M[U],S,U,A);else h(M,S,0,A)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function h(x,C,b,A){if(d(x,C,b,A)===!0){let S=x.__offset,y=x.value;if(Array.isArray(y)){let M=0;for(let U=0;U<y.length;U++){let N=y[U],L=_(N,!0);u(N,x.__data,M),M+=L.storage/Float32Array.BYTES_PER_ELEMENT}}else u(y,x.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,S,x.__data)}}function u(x,C,b){typeof x=="number"||typeof x=="boolean"?C[b]=x:x.isMatrix3?(C[b]=x.elements[0],C[b+1]=x.elements[1],C[b+2]=x.elements[2],C[b+3]=0,C[b+4]=x.elements[3],C[b+5]=x.elements[4],C[b+6]=x.elements[5],C[b+7]=0,C[b+8]=x.elements[6],C[b+9]=x.elements[7],C[b+10]=x.elements[8],C[b+11]=0):ArrayBuffer.isView(x)?C.set(x.subarray(0,C.length-b),b):x.toArray(C,b)}function d(x,C,b,A){let S=x.value,y=C+"_"+b;if(Array.isArray(S)){A[y]===void 0&&(A[y]=[]);let M=A[y],U=!1;for(let N=0;N<S.length;N++)f(S[N],M,N)===!0&&(U=!0);return U}return f(S,A,y)}function f(x,C,b){if(C[b]===void 0)return typeof x=="number"||typeof x=="boolean"?C[b]=x:ArrayBuffer.isView(x)?C[b]=x.slice():C[b]=x.clone(),!0;{let A=C[b];if(typeof x=="number"||typeof x=="boolean"){if(A!==x)return C[b]=x,!0}else{if(ArrayBuffer.isView(x))return!0;if(A.equals(x)===!1)return A.copy(x),!0}}return!1}function p(x){let C=x.uniforms,b=0,A=16;for(let y=0,M=C.length;y<M;y++){let U=Array.isArray(C[y])?C[y]:[C[y]];for(let N=0,L=U.length;N<L;N++){let V=U[N],W=Array.isArray(V.value)?V.value:[V.value],O=Array.isArray(C[y])||Array.isArray(V.value),G=b;for(let z=0,ce=W.length;z<ce;z++){let Z=W[z],J=_(Z,O),ie=b%A,fe=ie%J.boundary,de=ie+fe;b+=fe,de!==0&&A-de<J.storage&&(b+=A-de),z===0&&(G=b),b+=J.storage}let j=V.type==="int"?Int32Array:V.type==="uint"?Uint32Array:Float32Array;V.__data=new j((b-G)/Float32Array.BYTES_PER_ELEMENT),V.__offset=G}}let S=b%A;return S>0&&(b+=A-S),x.__size=b,x.__cache={},this}function _(x,C){let b={boundary:0,storage:0};return typeof x=="number"||typeof x=="boolean"?(b.boundary=4,b.storage=4):x.isVector2?(b.boundary=8,b.storage=8):x.isVector3||x.isColor?(b.boundary=16,b.storage=12):x.isVector4?(b.boundary=16,b.storage=16):x.isMatrix3?(b.boundary=16,b.storage=48):x.isMatrix4?(b.boundary=16,b.storage=64):x.isTexture?Ze("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(x)?(b.boundary=16,b.storage=x.byteLength):Ze("WebGLRenderer: Unsupported uniform value type.",x),C===!0&&(b.boundary=16,b.storage=Math.ceil(b.storage/16)*16),b}function m(x){let C=x.target;C.removeEventListener("dispose",m),i.deleteBuffer(s[C.id]),delete s[C.id],delete r[C.id]}function g(){for(let x in s)i.deleteBuffer(s[x]);s={},r={}}return{bind:o,update:a,dispose:g}}var pP=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),us=null;function mP(){return us===null&&(us=new Oh(pP,16,16,fr,Xi),us.name="DFG_LUT",us.minFilter=Kn,us.magFilter=Kn,us.wrapS=as,us.wrapT=as,us.generateMipmaps=!1,us.needsUpdate=!0),us}var Ju=class{constructor(e={}){let{canvas:t=Wx(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:d=!1,outputBufferType:f=ii}=e;this.isWebGLRenderer=!0;let p;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=n.getContextAttributes().alpha}else p=o;let _=f,m=new Set([gu,mu,pu]),g=new Set([ii,$i,ta,Vr,du,fu]),x=new Uint32Array(4),C=new Int32Array(4),b={textures:[],min:[],max:[],resolution:[]},A=null,S=null,y=[],M=[],U=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=hs,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let N=this,L=!1,V=null,W=null,O=null,G=null;this._outputColorSpace=gi;let j=0,z=0,ce=null,Z=-1,J=null,ie=new Jt,fe=new Jt,de=null,Q=new ot(0),ge=0,xe=t.width,Pe=t.height,we=1,Xe=null,at=null,$e=new Jt(0,0,xe,Pe),mt=new Jt(0,0,xe,Pe),dt=!1,st=new sr,Zt=new Uh,Ht=!1,hn=!1,kt=new yt,Cn=new I,wt=new Jt,yn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},tn=!1;function un(){return ce===null?we:1}let k=n;function Le(T,B){return t.getContext(T,B)}let Ke,lt,Ee,zt,We,je,R,w,$,he,oe,ye,ve,ee,ne,me,F,se,te,Te,_e,Me,qe;try{let T={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",ze,!1),t.addEventListener("webglcontextrestored",tt,!1),t.addEventListener("webglcontextcreationerror",Ie,!1),k===null){let B="webgl2";if(k=Le(B,T),k===null)throw Le(B)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}et()}catch(T){throw t.removeEventListener("webglcontextlost",ze,!1),t.removeEventListener("webglcontextrestored",tt,!1),t.removeEventListener("webglcontextcreationerror",Ie,!1),Qe("WebGLRenderer: "+T.message),T}function et(){Ke=new TC(k),Ke.init(),_e=new lP(k,Ke),lt=new mC(k,Ke,e,_e),Ee=new oP(k,Ke),lt.reversedDepthBuffer&&d&&Ee.buffers.depth.setReversed(!0),W=k.createFramebuffer(),O=k.createFramebuffer(),G=k.createFramebuffer(),zt=new RC(k),We=new qR,je=new aP(k,Ke,Ee,We,lt,_e,zt),R=new EC(N),w=new IT(k),Me=new fC(k,w),$=new AC(k,w,zt,Me),he=new IC(k,$,w,Me,zt),se=new PC(k,lt,je),ne=new gC(We),oe=new $R(N,R,Ke,lt,Me,ne),ye=new dP(N,We),ve=new YR,ee=new eP(Ke),F=new dC(N,R,Ee,he,p,l),me=new rP(N,he,lt),qe=new fP(k,zt,lt,Ee),te=new pC(k,Ke,zt),Te=new CC(k,Ke,zt),zt.programs=oe.programs,N.capabilities=lt,N.extensions=Ke,N.properties=We,N.renderLists=ve,N.shadowMap=me,N.state=Ee,N.info=zt}_!==ii&&(U=new DC(_,t.width,t.height,a,s,r));let le=new dm(N,k);this.xr=le,this.getContext=function(){return k},this.getContextAttributes=function(){return k.getContextAttributes()},this.forceContextLoss=function(){let T=Ke.get("WEBGL_lose_context");T&&T.loseContext()},this.forceContextRestore=function(){let T=Ke.get("WEBGL_lose_context");T&&T.restoreContext()},this.getPixelRatio=function(){return we},this.setPixelRatio=function(T){T!==void 0&&(we=T,this.setSize(xe,Pe,!1))},this.getSize=function(T){return T.set(xe,Pe)},this.setSize=function(T,B,K=!0){if(le.isPresenting){Ze("WebGLRenderer: Can't change size while VR device is presenting.");return}xe=T,Pe=B,t.width=Math.floor(T*we),t.height=Math.floor(B*we),K===!0&&(t.style.width=T+"px",t.style.height=B+"px"),U!==null&&U.setSize(t.width,t.height),this.setViewport(0,0,T,B)},this.getDrawingBufferSize=function(T){return T.set(xe*we,Pe*we).floor()},this.setDrawingBufferSize=function(T,B,K){xe=T,Pe=B,we=K,t.width=Math.floor(T*K),t.height=Math.floor(B*K),this.setViewport(0,0,T,B)},this.setEffects=function(T){if(_===ii){Qe("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(T){for(let B=0;B<T.length;B++)if(T[B].isOutputPass===!0){Ze("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}U.setEffects(T||[])},this.getCurrentViewport=function(T){return T.copy(ie)},this.getViewport=function(T){return T.copy($e)},this.setViewport=function(T,B,K,q){T.isVector4?$e.set(T.x,T.y,T.z,T.w):$e.set(T,B,K,q),Ee.viewport(ie.copy($e).multiplyScalar(un()).round())},this.getScissor=function(T){return T.copy(mt)},this.setScissor=function(T,B,K,q){T.isVector4?mt.set(T.x,T.y,T.z,T.w):mt.set(T,B,K,q),Ee.scissor(fe.copy(mt).multiplyScalar(un()).round())},this.getScissorTest=function(){return dt},this.setScissorTest=function(T){Ee.setScissorTest(dt=T)},this.setOpaqueSort=function(T){Xe=T},this.setTransparentSort=function(T){at=T},this.getClearColor=function(T){return T.copy(F.getClearColor())},this.setClearColor=function(){F.setClearColor(...arguments)},this.getClearAlpha=function(){return F.getClearAlpha()},this.setClearAlpha=function(){F.setClearAlpha(...arguments)},this.clear=function(T=!0,B=!0,K=!0){let q=0;if(T){let X=!1;if(ce!==null){let Ae=ce.texture.format;X=m.has(Ae)}if(X){let Ae=ce.texture.type,De=g.has(Ae),Ce=F.getClearColor(),Ne=F.getClearAlpha(),Ge=Ce.r,nt=Ce.g,gt=Ce.b;De?(x[0]=Ge,x[1]=nt,x[2]=gt,x[3]=Ne,k.clearBufferuiv(k.COLOR,0,x)):(C[0]=Ge,C[1]=nt,C[2]=gt,C[3]=Ne,k.clearBufferiv(k.COLOR,0,C))}else q|=k.COLOR_BUFFER_BIT}B&&(q|=k.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),K&&(q|=k.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),q!==0&&k.clear(q)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(T){T.setRenderer(this),V=T},this.dispose=function(){t.removeEventListener("webglcontextlost",ze,!1),t.removeEventListener("webglcontextrestored",tt,!1),t.removeEventListener("webglcontextcreationerror",Ie,!1),F.dispose(),ve.dispose(),ee.dispose(),je.dispose(),We.dispose(),R.dispose(),he.dispose(),$.dispose(),Me.dispose(),qe.dispose(),oe.dispose(),le.dispose(),le.removeEventListener("sessionstart",Bl),le.removeEventListener("sessionend",ji),fs.stop()};function ze(T){T.preventDefault(),tl("WebGLRenderer: Context Lost."),L=!0}function tt(){tl("WebGLRenderer: Context Restored."),L=!1;let T=zt.autoReset,B=me.enabled,K=me.autoUpdate,q=me.needsUpdate,X=me.type;et(),zt.autoReset=T,me.enabled=B,me.autoUpdate=K,me.needsUpdate=q,me.type=X}function Ie(T){Qe("WebGLRenderer: A WebGL context could not be created. Reason: ",T.statusMessage)}function ct(T){let B=T.target;B.removeEventListener("dispose",ct),Wt(B)}function Wt(T){Gn(T),We.remove(T)}function Gn(T){let B=We.get(T).programs;B!==void 0&&(B.forEach(function(K){oe.releaseProgram(K)}),T.isShaderMaterial&&oe.releaseShaderCache(T))}this.renderBufferDirect=function(T,B,K,q,X,Ae){B===null&&(B=yn);let De=X.isMesh&&X.matrixWorld.determinantAffine()<0,Ce=la(T,B,K,q,X);Ee.setMaterial(q,De);let Ne=K.index,Ge=1;if(q.wireframe===!0){if(Ne=$.getWireframeAttribute(K),Ne===void 0)return;Ge=2}let nt=K.drawRange,gt=K.attributes.position,Ve=nt.start*Ge,_t=(nt.start+nt.count)*Ge;Ae!==null&&(Ve=Math.max(Ve,Ae.start*Ge),_t=Math.min(_t,(Ae.start+Ae.count)*Ge)),Ne!==null?(Ve=Math.max(Ve,0),_t=Math.min(_t,Ne.count)):gt!=null&&(Ve=Math.max(Ve,0),_t=Math.min(_t,gt.count));let Qt=_t-Ve;if(Qt<0||Qt===1/0)return;Me.setup(X,q,Ce,K,Ne);let Ot,Ut=te;if(Ne!==null&&(Ot=w.get(Ne),Ut=Te,Ut.setIndex(Ot)),X.isMesh)q.wireframe===!0?(Ee.setLineWidth(q.wireframeLinewidth*un()),Ut.setMode(k.LINES)):Ut.setMode(k.TRIANGLES);else if(X.isLine){let xn=q.linewidth;xn===void 0&&(xn=1),Ee.setLineWidth(xn*un()),X.isLineSegments?Ut.setMode(k.LINES):X.isLineLoop?Ut.setMode(k.LINE_LOOP):Ut.setMode(k.LINE_STRIP)}else X.isPoints?Ut.setMode(k.POINTS):X.isSprite&&Ut.setMode(k.TRIANGLES);if(X.isBatchedMesh)if(Ke.get("WEBGL_multi_draw"))Ut.renderMultiDraw(X._multiDrawStarts,X._multiDrawCounts,X._multiDrawCount);else{let xn=X._multiDrawStarts,ke=X._multiDrawCounts,dn=X._multiDrawCount,vt=Ne?w.get(Ne).bytesPerElement:1,ms=We.get(q).currentProgram.getUniforms();for(let fn=0;fn<dn;fn++)ms.setValue(k,"_gl_DrawID",fn),Ut.render(xn[fn]/vt,ke[fn])}else if(X.isInstancedMesh)Ut.renderInstances(Ve,Qt,X.count);else if(K.isInstancedBufferGeometry){let xn=K._maxInstanceCount!==void 0?K._maxInstanceCount:1/0,ke=Math.min(K.instanceCount,xn);Ut.renderInstances(Ve,Qt,ke)}else Ut.render(Ve,Qt)};function ra(T,B,K,q){V!==null&&T.isNodeMaterial&&V.setObject(q,T),Ht===!0&&ne.setState(T,K,!1),T.transparent===!0&&T.side===Pi&&T.forceSinglePass===!1?(T.side=Qn,T.needsUpdate=!0,Zi(T,B,q),T.side=ur,T.needsUpdate=!0,Zi(T,B,q),T.side=Pi):Zi(T,B,q)}this.compile=function(T,B,K=null){K===null&&(K=T),V!==null&&V.renderStart(T,B,K),S=ee.get(K),S.init(B),M.push(S),K.traverseVisible(function(X){X.isLight&&X.layers.test(B.layers)&&(S.pushLight(X),X.castShadow&&S.pushShadow(X))}),T!==K&&T.traverseVisible(function(X){X.isLight&&X.layers.test(B.layers)&&(S.pushLight(X),X.castShadow&&S.pushShadow(X))}),S.setupLights(),V!==null&&V.updateLights(S.state.lightsArray),hn=this.localClippingEnabled,Ht=ne.init(this.clippingPlanes,hn),Ht===!0&&ne.setGlobalState(this.clippingPlanes,B),V!==null&&me.render(S.state.shadowsArray,K,B);let q=new Set;return T.traverse(function(X){if(!(X.isMesh||X.isPoints||X.isLine||X.isSprite))return;let Ae=X.material;if(Ae)if(Array.isArray(Ae))for(let De=0;De<Ae.length;De++){let Ce=Ae[De];ra(Ce,K,B,X),q.add(Ce)}else ra(Ae,K,B,X),q.add(Ae)}),S=M.pop(),V!==null&&V.renderEnd(),q},this.compileAsync=function(T,B,K=null){let q=this.compile(T,B,K);return new Promise(X=>{function Ae(){if(q.forEach(function(De){let Ne=We.get(De).currentProgram;(Ne===void 0||Ne.isReady())&&q.delete(De)}),q.size===0){X(T);return}setTimeout(Ae,10)}Ke.get("KHR_parallel_shader_compile")!==null?Ae():setTimeout(Ae,10)})};let $r=null;function gd(T){$r&&$r(T)}function Bl(){fs.stop()}function ji(){fs.start()}let fs=new vv;fs.setAnimationLoop(gd),typeof self<"u"&&fs.setContext(self),this.setAnimationLoop=function(T){$r=T,le.setAnimationLoop(T),T===null?fs.stop():fs.start()},le.addEventListener("sessionstart",Bl),le.addEventListener("sessionend",ji),this.render=function(T,B){if(B!==void 0&&B.isCamera!==!0){Qe("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(L===!0)return;V!==null&&V.renderStart(T,B);let K=le.enabled===!0&&le.isPresenting===!0,q=U!==null&&(ce===null||K)&&U.begin(N,ce);if(T.matrixWorldAutoUpdate===!0&&T.updateMatrixWorld(),B.parent===null&&B.matrixWorldAutoUpdate===!0&&B.updateMatrixWorld(),le.enabled===!0&&le.isPresenting===!0&&(U===null||U.isCompositing()===!1)&&(le.cameraAutoUpdate===!0&&le.updateCamera(B),B=le.getCamera()),T.isScene===!0&&T.onBeforeRender(N,T,B,ce),S=ee.get(T,M.length),S.init(B),S.state.textureUnits=je.getTextureUnits(),M.push(S),kt.multiplyMatrices(B.projectionMatrix,B.matrixWorldInverse),B.isArrayCamera?Zt.setFromArrayCamera(B):st.setFromProjectionMatrix(kt,Ai,B.reversedDepth),hn=this.localClippingEnabled,Ht=ne.init(this.clippingPlanes,hn),A=ve.get(T,y.length),A.init(),y.push(A),this.info.render.frame++,le.enabled===!0&&le.isPresenting===!0){let De=N.xr.getDepthSensingMesh();De!==null&&ps(De,B,-1/0,N.sortObjects)}ps(T,B,0,N.sortObjects),A.finish(),V!==null&&V.updateLights(S.state.lightsArray),N.sortObjects===!0&&A.sort(Xe,at),tn=le.enabled===!1||le.isPresenting===!1||le.hasDepthSensing()===!1,tn&&F.addToRenderList(A,T),this.info.autoReset===!0&&this.info.reset(),Ht===!0&&ne.beginShadows();let X=S.state.shadowsArray;if(me.render(X,T,B),Ht===!0&&ne.endShadows(),(q&&U.hasRenderPass())===!1){let De=A.opaque,Ce=A.transmissive;if(S.setupLights(),B.isArrayCamera){let Ne=B.cameras;if(Ce.length>0)for(let Ge=0,nt=Ne.length;Ge<nt;Ge++){let gt=Ne[Ge];Li(De,Ce,T,gt)}tn&&F.render(T);for(let Ge=0,nt=Ne.length;Ge<nt;Ge++){let gt=Ne[Ge];oa(A,T,gt,gt.viewport)}}else Ce.length>0&&Li(De,Ce,T,B),tn&&F.render(T),oa(A,T,B)}ce!==null&&z===0&&(je.updateMultisampleRenderTarget(ce),je.updateRenderTargetMipmap(ce)),q&&U.end(N),T.isScene===!0&&T.onAfterRender(N,T,B),Me.resetDefaultState(),Z=-1,J=null,M.pop(),M.length>0?(S=M[M.length-1],je.setTextureUnits(S.state.textureUnits),Ht===!0&&ne.setGlobalState(N.clippingPlanes,S.state.camera)):S=null,y.pop(),y.length>0?A=y[y.length-1]:A=null,V!==null&&V.renderEnd()};function ps(T,B,K,q){if(T.visible===!1)return;if(T.layers.test(B.layers)){if(T.isGroup)K=T.renderOrder;else if(T.isLOD)T.autoUpdate===!0&&T.update(B);else if(T.isLight)S.pushLight(T),T.castShadow&&S.pushShadow(T);else if(T.isSprite){let De=B.isArrayCamera?Zt:st;if(!T.frustumCulled||T.intersectsFrustum(De)){q&&wt.setFromMatrixPosition(T.matrixWorld).applyMatrix4(kt);let Ce=he.update(T),Ne=T.material;Ne.visible&&A.push(T,Ce,Ne,K,wt.z,null,B)}}else if(T.isMesh||T.isLine||T.isPoints){let De=B.isArrayCamera?Zt:st;if(!T.frustumCulled||T.intersectsFrustum(De)){let Ce=he.update(T),Ne=T.material;if(q&&(T.boundingSphere!==void 0?(T.boundingSphere===null&&T.computeBoundingSphere(),wt.copy(T.boundingSphere.center)):(Ce.boundingSphere===null&&Ce.computeBoundingSphere(),wt.copy(Ce.boundingSphere.center)),wt.applyMatrix4(T.matrixWorld).applyMatrix4(kt)),Array.isArray(Ne)){let Ge=Ce.groups;for(let nt=0,gt=Ge.length;nt<gt;nt++){let Ve=Ge[nt],_t=Ne[Ve.materialIndex];_t&&_t.visible&&A.push(T,Ce,_t,K,wt.z,Ve,B)}}else Ne.visible&&A.push(T,Ce,Ne,K,wt.z,null,B)}}}let Ae=T.children;for(let De=0,Ce=Ae.length;De<Ce;De++)ps(Ae[De],B,K,q)}function oa(T,B,K,q){let{opaque:X,transmissive:Ae,transparent:De}=T;S.setupLightsView(K),Ht===!0&&ne.setGlobalState(N.clippingPlanes,K),q&&Ee.viewport(ie.copy(q)),X.length>0&&nn(X,B,K),Ae.length>0&&nn(Ae,B,K),De.length>0&&nn(De,B,K),Ee.buffers.depth.setTest(!0),Ee.buffers.depth.setMask(!0),Ee.buffers.color.setMask(!0),Ee.setPolygonOffset(!1)}function Li(T,B,K,q){if((K.isScene===!0?K.overrideMaterial:null)!==null)return;if(S.state.transmissionRenderTarget[q.id]===void 0){let Ve=Ke.has("EXT_color_buffer_half_float")||Ke.has("EXT_color_buffer_float");S.state.transmissionRenderTarget[q.id]=new xi(1,1,{generateMipmaps:!0,type:Ve?Xi:ii,minFilter:Us,samples:Math.max(4,lt.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:St.workingColorSpace})}let Ae=S.state.transmissionRenderTarget[q.id],De=q.viewport||ie;Ae.setSize(De.z*N.transmissionResolutionScale,De.w*N.transmissionResolutionScale);let Ce=N.getRenderTarget(),Ne=N.getActiveCubeFace(),Ge=N.getActiveMipmapLevel();N.setRenderTarget(Ae),N.getClearColor(Q),ge=N.getClearAlpha(),ge<1&&N.setClearColor(16777215,.5),N.clear(),tn&&F.render(K);let nt=N.toneMapping;N.toneMapping=hs;let gt=q.viewport;if(q.viewport!==void 0&&(q.viewport=void 0),S.setupLightsView(q),Ht===!0&&ne.setGlobalState(N.clippingPlanes,q),nn(T,K,q),je.updateMultisampleRenderTarget(Ae),je.updateRenderTargetMipmap(Ae),Ke.has("WEBGL_multisampled_render_to_texture")===!1){let Ve=!1;for(let _t=0,Qt=B.length;_t<Qt;_t++){let Ot=B[_t],{object:Ut,geometry:xn,material:ke,group:dn}=Ot;if(ke.side===Pi&&Ut.layers.test(q.layers)){let vt=ke.side;ke.side=Qn,ke.needsUpdate=!0,an(Ut,K,q,xn,ke,dn),ke.side=vt,ke.needsUpdate=!0,Ve=!0}}Ve===!0&&(je.updateMultisampleRenderTarget(Ae),je.updateRenderTargetMipmap(Ae))}N.setRenderTarget(Ce,Ne,Ge),N.setClearColor(Q,ge),gt!==void 0&&(q.viewport=gt),N.toneMapping=nt}function nn(T,B,K){let q=B.isScene===!0?B.overrideMaterial:null;for(let X=0,Ae=T.length;X<Ae;X++){let De=T[X],{object:Ce,geometry:Ne,group:Ge}=De,nt=De.material;nt.allowOverride===!0&&q!==null&&(nt=q),Ce.layers.test(K.layers)&&an(Ce,B,K,Ne,nt,Ge)}}function an(T,B,K,q,X,Ae){V!==null&&X.isNodeMaterial&&V.setObject(T,X),T.onBeforeRender(N,B,K,q,X,Ae),T.modelViewMatrix.multiplyMatrices(K.matrixWorldInverse,T.matrixWorld),T.normalMatrix.getNormalMatrix(T.modelViewMatrix),X.onBeforeRender(N,B,K,q,T,Ae),X.transparent===!0&&X.side===Pi&&X.forceSinglePass===!1?(X.side=Qn,X.needsUpdate=!0,N.renderBufferDirect(K,B,q,X,T,Ae),X.side=ur,X.needsUpdate=!0,N.renderBufferDirect(K,B,q,X,T,Ae),X.side=Pi):N.renderBufferDirect(K,B,q,X,T,Ae),T.onAfterRender(N,B,K,q,X,Ae)}function ln(T){let B=0;for(let K of T)K.texture!==null&&B++;return B}function Zi(T,B,K){B.isScene!==!0&&(B=yn);let q=We.get(T),X=S.state.lights,Ae=S.state.shadowsArray,De=X.state.version,Ce=oe.getParameters(T,X.state,Ae,B,K,S.state.lightProbeGridArray),Ne=oe.getProgramCacheKey(Ce),Ge=q.programs;q.environment=T.isMeshStandardMaterial||T.isMeshLambertMaterial||T.isMeshPhongMaterial?B.environment:null,q.fog=B.fog;let nt=T.isMeshStandardMaterial||T.isMeshLambertMaterial&&!T.envMap||T.isMeshPhongMaterial&&!T.envMap;q.envMap=R.get(T.envMap||q.environment,nt),q.envMapRotation=q.environment!==null&&T.envMap===null?B.environmentRotation:T.envMapRotation,Ge===void 0&&(T.addEventListener("dispose",ct),Ge=new Map,q.programs=Ge,q.programVariants=new Map);let gt=Ge.get(Ne);if(gt!==void 0){if(q.currentProgram===gt&&q.lightsStateVersion===De)return aa(T,Ce),gt}else Ce.uniforms=oe.getUniforms(T),V!==null&&T.isNodeMaterial&&V.build(T,K,Ce),T.onBeforeCompile(Ce,N),gt=oe.acquireProgram(Ce,Ne),Ge.set(Ne,gt),q.uniforms=Ce.uniforms;let Ve=q.uniforms;return(!T.isShaderMaterial&&!T.isRawShaderMaterial||T.clipping===!0)&&(Ve.clippingPlanes=ne.uniform),aa(T,Ce),q.needsLights=Gs(T),q.lightsStateVersion=De,q.needsLights&&(Ve.ambientLightColor.value=X.state.ambient,Ve.lightProbe.value=X.state.probe,Ve.sunLights.value=X.state.sun,Ve.sunLightShadows.value=X.state.sunShadow,Ve.directionalLights.value=X.state.directional,Ve.directionalLightShadows.value=X.state.directionalShadow,Ve.spotLights.value=X.state.spot,Ve.spotLightShadows.value=X.state.spotShadow,Ve.rectAreaLights.value=X.state.rectArea,Ve.ltc_1.value=X.state.rectAreaLTC1,Ve.ltc_2.value=X.state.rectAreaLTC2,Ve.pointLights.value=X.state.point,Ve.pointLightShadows.value=X.state.pointShadow,Ve.hemisphereLights.value=X.state.hemi,Ve.sunShadowMatrix.value=X.state.sunShadowMatrix,Ve.sunShadowCascade.value=X.state.sunShadowCascade,Ve.directionalShadowMatrix.value=X.state.directionalShadowMatrix,Ve.spotLightMatrix.value=X.state.spotLightMatrix,Ve.spotLightMap.value=X.state.spotLightMap,Ve.pointShadowMatrix.value=X.state.pointShadowMatrix),q.numLightProbeGrids=ln(S.state.lightProbeGridArray),q.currentProgram=gt,q.uniformsList=null,gt}function ri(T,B,K,q,X){let Ae=We.get(T),De=Ae.currentProgram.id+","+q+","+X,Ce=Ae.programVariants.get(De);return Ce===void 0?(Ce=Zi(T,B,K),Ae.programVariants.set(De,Ce)):(Ae.currentProgram=Ce,Ae.uniformsList=null,Ae.outputColorSpace=q,Ae.toneMapping=X),Ce}function Vs(T){if(T.uniformsList===null){let B=T.currentProgram.getUniforms();T.uniformsList=na.seqWithValue(B.seq,T.uniforms)}return T.uniformsList}function aa(T,B){let K=We.get(T);K.outputColorSpace=B.outputColorSpace,K.batching=B.batching,K.batchingColor=B.batchingColor,K.instancing=B.instancing,K.instancingColor=B.instancingColor,K.instancingMorph=B.instancingMorph,K.skinning=B.skinning,K.morphTargets=B.morphTargets,K.morphNormals=B.morphNormals,K.morphColors=B.morphColors,K.morphTargetsCount=B.morphTargetsCount,K.numClippingPlanes=B.numClippingPlanes,K.numIntersection=B.numClipIntersection,K.vertexAlphas=B.vertexAlphas,K.vertexTangents=B.vertexTangents,K.toneMapping=B.toneMapping}function la(T,B,K,q,X){B.isScene!==!0&&(B=yn),je.resetTextureUnits();let Ae=B.fog,De=q.isMeshStandardMaterial||q.isMeshLambertMaterial||q.isMeshPhongMaterial?B.environment:null,Ce=ce===null?N.outputColorSpace:ce.isXRRenderTarget===!0?ce.texture.colorSpace:St.workingColorSpace,Ne=q.isMeshStandardMaterial||q.isMeshLambertMaterial&&!q.envMap||q.isMeshPhongMaterial&&!q.envMap,Ge=R.get(q.envMap||De,Ne),nt=q.vertexColors===!0&&!!K.attributes.color&&K.attributes.color.itemSize===4,gt=!!K.attributes.tangent&&(!!q.normalMap||q.anisotropy>0),Ve=!!K.morphAttributes.position,_t=!!K.morphAttributes.normal,Qt=!!K.morphAttributes.color,Ot=hs;q.toneMapped&&(ce===null||ce.isXRRenderTarget===!0)&&(Ot=N.toneMapping);let Ut=K.morphAttributes.position||K.morphAttributes.normal||K.morphAttributes.color,xn=Ut!==void 0?Ut.length:0,ke=We.get(q),dn=S.state.lights;if(Ht===!0&&(hn===!0||T!==J)){let Ft=T===J&&q.id===Z;ne.setState(q,T,Ft)}let vt=!1,ms=!1;q.version===ke.__version?ke.needsLights&&ke.lightsStateVersion!==dn.state.version||X.isBatchedMesh&&ke.batching===!1||!X.isBatchedMesh&&ke.batching===!0||X.isBatchedMesh&&ke.batchingColor===!0&&X._colorsTexture===null||X.isBatchedMesh&&ke.batchingColor===!1&&X._colorsTexture!==null||X.isInstancedMesh&&ke.instancing===!1||!X.isInstancedMesh&&ke.instancing===!0||X.isSkinnedMesh&&ke.skinning===!1||!X.isSkinnedMesh&&ke.skinning===!0||X.isInstancedMesh&&ke.instancingColor===!0&&X.instanceColor===null||X.isInstancedMesh&&ke.instancingColor===!1&&X.instanceColor!==null||X.isInstancedMesh&&ke.instancingMorph===!0&&X.morphTexture===null||X.isInstancedMesh&&ke.instancingMorph===!1&&X.morphTexture!==null||ke.envMap!==Ge||q.fog===!0&&ke.fog!==Ae||ke.numClippingPlanes!==void 0&&(ke.numClippingPlanes!==ne.numPlanes||ke.numIntersection!==ne.numIntersection)||ke.vertexAlphas!==nt||ke.vertexTangents!==gt||ke.morphTargets!==Ve||ke.morphNormals!==_t||ke.morphColors!==Qt||ke.morphTargetsCount!==xn||ke.numLightProbeGrids!==ln(S.state.lightProbeGridArray)?vt=!0:(ke.outputColorSpace!==Ce||ke.toneMapping!==Ot)&&(ms=!0):(vt=!0,ke.__version=q.version);let fn=ke.currentProgram;(vt===!0||ms===!0)&&(fn=ms===!0?ri(q,B,X,Ce,Ot):Zi(q,B,X),V&&q.isNodeMaterial&&V.onUpdateProgram(q,fn,ke));let Yr=!1,Ki=!1,gs=!1,ft=fn.getUniforms(),sn=ke.uniforms;if(Ee.useProgram(fn.program)&&(Yr=!0,Ki=!0,gs=!0),q.id!==Z&&(Z=q.id,Ki=!0),Yr||J!==T){Ee.buffers.depth.getReversed()&&T.reversedDepth!==!0&&(T._reversedDepth=!0,T.updateProjectionMatrix()),ft.setValue(k,"projectionMatrix",T.projectionMatrix),ft.setValue(k,"viewMatrix",T.matrixWorldInverse);let pn=ft.map.cameraPosition;pn!==void 0&&pn.setValue(k,Cn.setFromMatrixPosition(T.matrixWorld)),lt.logarithmicDepthBuffer&&ft.setValue(k,"logDepthBufFC",2/(Math.log(T.far+1)/Math.LN2)),(q.isMeshPhongMaterial||q.isMeshToonMaterial||q.isMeshLambertMaterial||q.isMeshBasicMaterial||q.isMeshStandardMaterial||q.isShaderMaterial)&&ft.setValue(k,"isOrthographic",T.isOrthographicCamera===!0),J!==T&&(J=T,Ki=!0,gs=!0)}if(ke.needsLights&&(dn.state.sunShadowMap.length>0&&ft.setValue(k,"sunShadowMap",dn.state.sunShadowMap,je),dn.state.directionalShadowMap.length>0&&ft.setValue(k,"directionalShadowMap",dn.state.directionalShadowMap,je),dn.state.spotShadowMap.length>0&&ft.setValue(k,"spotShadowMap",dn.state.spotShadowMap,je),dn.state.pointShadowMap.length>0&&ft.setValue(k,"pointShadowMap",dn.state.pointShadowMap,je)),X.isSkinnedMesh){ft.setOptional(k,X,"bindMatrix"),ft.setOptional(k,X,"bindMatrixInverse");let Ft=X.skeleton;Ft&&(Ft.boneTexture===null&&Ft.computeBoneTexture(),ft.setValue(k,"boneTexture",Ft.boneTexture,je))}X.isBatchedMesh&&(ft.setOptional(k,X,"batchingTexture"),ft.setValue(k,"batchingTexture",X._matricesTexture,je),ft.setOptional(k,X,"batchingIdTexture"),ft.setValue(k,"batchingIdTexture",X._indirectTexture,je),ft.setOptional(k,X,"batchingColorTexture"),X._colorsTexture!==null&&ft.setValue(k,"batchingColorTexture",X._colorsTexture,je));let Hn=K.morphAttributes;if((Hn.position!==void 0||Hn.normal!==void 0||Hn.color!==void 0)&&se.update(X,K,fn),(Ki||ke.receiveShadow!==X.receiveShadow)&&(ke.receiveShadow=X.receiveShadow,ft.setValue(k,"receiveShadow",X.receiveShadow)),(q.isMeshStandardMaterial||q.isMeshLambertMaterial||q.isMeshPhongMaterial)&&q.envMap===null&&B.environment!==null&&(sn.envMapIntensity.value=B.environmentIntensity),sn.dfgLUT!==void 0&&(sn.dfgLUT.value=mP()),Ki){if(ft.setValue(k,"toneMappingExposure",N.toneMappingExposure),ke.needsLights&&qr(sn,gs),Ae&&q.fog===!0&&ye.refreshFogUniforms(sn,Ae),ye.refreshMaterialUniforms(sn,q,we,Pe,S.state.transmissionRenderTarget[T.id]),ke.needsLights&&ke.numLightProbeGrids>0){let Ft=b,pn=0;for(let kn of S.state.lightProbeGridArray)kn.texture!==null&&(Ft.textures[pn]=kn.texture,Ft.min[pn]=kn.boundingBox.min,Ft.max[pn]=kn.boundingBox.max,Ft.resolution[pn]=kn.resolution,pn++);for(let kn in Ft)Ft[kn].length=pn;sn.probesSH.value=Ft.textures,sn.probesMin.value=Ft.min,sn.probesMax.value=Ft.max,sn.probesResolution.value=Ft.resolution}na.upload(k,Vs(ke),sn,je)}if(q.isShaderMaterial&&q.uniformsNeedUpdate===!0&&(na.upload(k,Vs(ke),sn,je),q.uniformsNeedUpdate=!1),q.isSpriteMaterial&&ft.setValue(k,"center",X.center),ft.setValue(k,"modelViewMatrix",X.modelViewMatrix),ft.setValue(k,"normalMatrix",X.normalMatrix),ft.setValue(k,"modelMatrix",X.matrixWorld),q.uniformsGroups!==void 0){let Ft=q.uniformsGroups;for(let pn=0,kn=Ft.length;pn<kn;pn++){let zl=Ft[pn];qe.update(zl,fn),qe.bind(zl,fn)}}return fn}function qr(T,B){T.ambientLightColor.needsUpdate=B,T.lightProbe.needsUpdate=B,T.sunLights.needsUpdate=B,T.sunLightShadows.needsUpdate=B,T.directionalLights.needsUpdate=B,T.directionalLightShadows.needsUpdate=B,T.pointLights.needsUpdate=B,T.pointLightShadows.needsUpdate=B,T.spotLights.needsUpdate=B,T.spotLightShadows.needsUpdate=B,T.rectAreaLights.needsUpdate=B,T.hemisphereLights.needsUpdate=B}function Gs(T){return T.isMeshLambertMaterial||T.isMeshToonMaterial||T.isMeshPhongMaterial||T.isMeshStandardMaterial||T.isShadowMaterial||T.isShaderMaterial&&T.lights===!0}this.getActiveCubeFace=function(){return j},this.getActiveMipmapLevel=function(){return z},this.getRenderTarget=function(){return ce},this.setRenderTargetTextures=function(T,B,K){let q=We.get(T);q.__autoAllocateDepthBuffer=T.resolveDepthBuffer===!1,q.__autoAllocateDepthBuffer===!1&&(q.__useRenderToTexture=!1),We.get(T.texture).__webglTexture=B,We.get(T.depthTexture).__webglTexture=q.__autoAllocateDepthBuffer?void 0:K,q.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(T,B){let K=We.get(T);K.__webglFramebuffer=B,K.__useDefaultFramebuffer=B===void 0},this.setRenderTarget=function(T,B=0,K=0){ce=T,j=B,z=K;let q=null,X=!1,Ae=!1;if(T){let Ce=We.get(T);if(Ce.__useDefaultFramebuffer!==void 0){Ee.bindFramebuffer(k.FRAMEBUFFER,Ce.__webglFramebuffer),ie.copy(T.viewport),fe.copy(T.scissor),de=T.scissorTest,Ee.viewport(ie),Ee.scissor(fe),Ee.setScissorTest(de),Z=-1;return}else if(Ce.__webglFramebuffer===void 0)je.setupRenderTarget(T);else if(Ce.__hasExternalTextures)je.rebindTextures(T,We.get(T.texture).__webglTexture,We.get(T.depthTexture).__webglTexture);else if(T.depthBuffer){let nt=T.depthTexture;if(Ce.__boundDepthTexture!==nt){if(nt!==null&&We.has(nt)&&(T.width!==nt.image.width||T.height!==nt.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");je.setupDepthRenderbuffer(T)}}let Ne=T.texture;(Ne.isData3DTexture||Ne.isDataArrayTexture||Ne.isCompressedArrayTexture)&&(Ae=!0);let Ge=We.get(T).__webglFramebuffer;T.isWebGLCubeRenderTarget?(Array.isArray(Ge[B])?q=Ge[B][K]:q=Ge[B],X=!0):T.samples>0&&je.useMultisampledRTT(T)===!1?q=We.get(T).__webglMultisampledFramebuffer:Array.isArray(Ge)?q=Ge[K]:q=Ge,ie.copy(T.viewport),fe.copy(T.scissor),de=T.scissorTest}else ie.copy($e).multiplyScalar(we).floor(),fe.copy(mt).multiplyScalar(we).floor(),de=dt;if(K!==0&&(q=W),Ee.bindFramebuffer(k.FRAMEBUFFER,q)&&Ee.drawBuffers(T,q),Ee.viewport(ie),Ee.scissor(fe),Ee.setScissorTest(de),X){let Ce=We.get(T.texture);k.framebufferTexture2D(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_CUBE_MAP_POSITIVE_X+B,Ce.__webglTexture,K)}else if(Ae){let Ce=B;for(let Ne=0;Ne<T.textures.length;Ne++){let Ge=We.get(T.textures[Ne]);k.framebufferTextureLayer(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0+Ne,Ge.__webglTexture,K,Ce)}}else if(T!==null&&K!==0){let Ce=We.get(T.texture);k.framebufferTexture2D(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,Ce.__webglTexture,K)}Z=-1};function Xr(T){let B=We.get(T);return(B.__readFormat!==T.format||B.__readType!==T.type)&&(B.__readFormat=T.format,B.__readType=T.type,B.__formatReadable=lt.textureFormatReadable(T.format),B.__typeReadable=lt.textureTypeReadable(T.type)),B}this.readRenderTargetPixels=function(T,B,K,q,X,Ae,De,Ce=0){if(!(T&&T.isWebGLRenderTarget)){Qe("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ne=We.get(T).__webglFramebuffer;if(T.isWebGLCubeRenderTarget&&De!==void 0&&(Ne=Ne[De],Array.isArray(Ne)&&(Ne=Ne[0])),Ne){Ee.bindFramebuffer(k.FRAMEBUFFER,Ne);try{let Ge=T.textures[Ce],nt=Ge.format,gt=Ge.type;T.textures.length>1&&k.readBuffer(k.COLOR_ATTACHMENT0+Ce);let Ve=Xr(Ge);if(Ve.__formatReadable===!1){Qe("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Ve.__typeReadable===!1){Qe("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}B>=0&&B<=T.width-q&&K>=0&&K<=T.height-X&&k.readPixels(B,K,q,X,_e.convert(nt),_e.convert(gt),Ae)}finally{let Ge=ce!==null?We.get(ce).__webglFramebuffer:null;Ee.bindFramebuffer(k.FRAMEBUFFER,Ge)}}},this.readRenderTargetPixelsAsync=async function(T,B,K,q,X,Ae,De,Ce=0){if(!(T&&T.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ne=We.get(T).__webglFramebuffer;if(T.isWebGLCubeRenderTarget&&De!==void 0&&(Ne=Ne[De],Array.isArray(Ne)&&(Ne=Ne[0])),Ne)if(B>=0&&B<=T.width-q&&K>=0&&K<=T.height-X){Ee.bindFramebuffer(k.FRAMEBUFFER,Ne);let Ge=T.textures[Ce],nt=Ge.format,gt=Ge.type;T.textures.length>1&&k.readBuffer(k.COLOR_ATTACHMENT0+Ce);let Ve=Xr(Ge);if(Ve.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Ve.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let _t=k.createBuffer();k.bindBuffer(k.PIXEL_PACK_BUFFER,_t),k.bufferData(k.PIXEL_PACK_BUFFER,Ae.byteLength,k.STREAM_READ),k.readPixels(B,K,q,X,_e.convert(nt),_e.convert(gt),0),k.bindBuffer(k.PIXEL_PACK_BUFFER,null);let Qt=ce!==null?We.get(ce).__webglFramebuffer:null;Ee.bindFramebuffer(k.FRAMEBUFFER,Qt);let Ot=k.fenceSync(k.SYNC_GPU_COMMANDS_COMPLETE,0);return k.flush(),await qx(k,Ot,4),k.bindBuffer(k.PIXEL_PACK_BUFFER,_t),k.getBufferSubData(k.PIXEL_PACK_BUFFER,0,Ae),k.bindBuffer(k.PIXEL_PACK_BUFFER,null),k.deleteBuffer(_t),k.deleteSync(Ot),Ae}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(T,B=null,K=0){let q=Math.pow(2,-K),X=Math.floor(T.image.width*q),Ae=Math.floor(T.image.height*q),De=B!==null?B.x:0,Ce=B!==null?B.y:0;je.setTexture2D(T,0),k.copyTexSubImage2D(k.TEXTURE_2D,K,0,0,De,Ce,X,Ae),Ee.unbindTexture()},this.copyTextureToTexture=function(T,B,K=null,q=null,X=0,Ae=0){let De,Ce,Ne,Ge,nt,gt,Ve,_t,Qt,Ot=T.isCompressedTexture?T.mipmaps[Ae]:T.image;if(K!==null)De=K.max.x-K.min.x,Ce=K.max.y-K.min.y,Ne=K.isBox3?K.max.z-K.min.z:1,Ge=K.min.x,nt=K.min.y,gt=K.isBox3?K.min.z:0;else{let ft=Math.pow(2,-X);De=Math.floor(Ot.width*ft),Ce=Math.floor(Ot.height*ft),T.isDataArrayTexture?Ne=Ot.depth:T.isData3DTexture?Ne=Math.floor(Ot.depth*ft):Ne=1,Ge=0,nt=0,gt=0}q!==null?(Ve=q.x,_t=q.y,Qt=q.z):(Ve=0,_t=0,Qt=0);let Ut=_e.convert(B.format),xn=_e.convert(B.type),ke;B.isData3DTexture?(je.setTexture3D(B,0),ke=k.TEXTURE_3D):B.isDataArrayTexture||B.isCompressedArrayTexture?(je.setTexture2DArray(B,0),ke=k.TEXTURE_2D_ARRAY):(je.setTexture2D(B,0),ke=k.TEXTURE_2D),Ee.activeTexture(k.TEXTURE0),Ee.pixelStorei(k.UNPACK_FLIP_Y_WEBGL,B.flipY),Ee.pixelStorei(k.UNPACK_PREMULTIPLY_ALPHA_WEBGL,B.premultiplyAlpha),Ee.pixelStorei(k.UNPACK_ALIGNMENT,B.unpackAlignment);let dn=Ee.getParameter(k.UNPACK_ROW_LENGTH),vt=Ee.getParameter(k.UNPACK_IMAGE_HEIGHT),ms=Ee.getParameter(k.UNPACK_SKIP_PIXELS),fn=Ee.getParameter(k.UNPACK_SKIP_ROWS),Yr=Ee.getParameter(k.UNPACK_SKIP_IMAGES);Ee.pixelStorei(k.UNPACK_ROW_LENGTH,Ot.width),Ee.pixelStorei(k.UNPACK_IMAGE_HEIGHT,Ot.height),Ee.pixelStorei(k.UNPACK_SKIP_PIXELS,Ge),Ee.pixelStorei(k.UNPACK_SKIP_ROWS,nt),Ee.pixelStorei(k.UNPACK_SKIP_IMAGES,gt);let Ki=T.isDataArrayTexture||T.isData3DTexture,gs=B.isDataArrayTexture||B.isData3DTexture;if(T.isDepthTexture){let ft=We.get(T),sn=We.get(B),Hn=We.get(ft.__renderTarget),Ft=We.get(sn.__renderTarget);Ee.bindFramebuffer(k.READ_FRAMEBUFFER,Hn.__webglFramebuffer),Ee.bindFramebuffer(k.DRAW_FRAMEBUFFER,Ft.__webglFramebuffer);for(let pn=0;pn<Ne;pn++)Ki&&(k.framebufferTextureLayer(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,We.get(T).__webglTexture,X,gt+pn),k.framebufferTextureLayer(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,We.get(B).__webglTexture,Ae,Qt+pn)),k.blitFramebuffer(Ge,nt,Ge+De,nt+Ce,Ve,_t,Ve+De,_t+Ce,k.DEPTH_BUFFER_BIT,k.NEAREST);Ee.bindFramebuffer(k.READ_FRAMEBUFFER,null),Ee.bindFramebuffer(k.DRAW_FRAMEBUFFER,null)}else if(X!==0||T.isRenderTargetTexture||We.has(T)){let ft=We.get(T),sn=We.get(B);Ee.bindFramebuffer(k.READ_FRAMEBUFFER,O),Ee.bindFramebuffer(k.DRAW_FRAMEBUFFER,G);for(let Hn=0;Hn<Ne;Hn++)Ki?k.framebufferTextureLayer(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,ft.__webglTexture,X,gt+Hn):k.framebufferTexture2D(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,ft.__webglTexture,X),gs?k.framebufferTextureLayer(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,sn.__webglTexture,Ae,Qt+Hn):k.framebufferTexture2D(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,sn.__webglTexture,Ae),X!==0?k.blitFramebuffer(Ge,nt,Ge+De,nt+Ce,Ve,_t,Ve+De,_t+Ce,k.COLOR_BUFFER_BIT,k.NEAREST):gs?k.copyTexSubImage3D(ke,Ae,Ve,_t,Qt+Hn,Ge,nt,De,Ce):k.copyTexSubImage2D(ke,Ae,Ve,_t,Ge,nt,De,Ce);Ee.bindFramebuffer(k.READ_FRAMEBUFFER,null),Ee.bindFramebuffer(k.DRAW_FRAMEBUFFER,null)}else gs?T.isDataTexture||T.isData3DTexture?k.texSubImage3D(ke,Ae,Ve,_t,Qt,De,Ce,Ne,Ut,xn,Ot.data):B.isCompressedArrayTexture?k.compressedTexSubImage3D(ke,Ae,Ve,_t,Qt,De,Ce,Ne,Ut,Ot.data):k.texSubImage3D(ke,Ae,Ve,_t,Qt,De,Ce,Ne,Ut,xn,Ot):T.isDataTexture?k.texSubImage2D(k.TEXTURE_2D,Ae,Ve,_t,De,Ce,Ut,xn,Ot.data):T.isCompressedTexture?k.compressedTexSubImage2D(k.TEXTURE_2D,Ae,Ve,_t,Ot.width,Ot.height,Ut,Ot.data):k.texSubImage2D(k.TEXTURE_2D,Ae,Ve,_t,De,Ce,Ut,xn,Ot);Ee.pixelStorei(k.UNPACK_ROW_LENGTH,dn),Ee.pixelStorei(k.UNPACK_IMAGE_HEIGHT,vt),Ee.pixelStorei(k.UNPACK_SKIP_PIXELS,ms),Ee.pixelStorei(k.UNPACK_SKIP_ROWS,fn),Ee.pixelStorei(k.UNPACK_SKIP_IMAGES,Yr),Ae===0&&B.generateMipmaps===!0&&B.mipmapsAutoUpdate===!0&&k.generateMipmap(ke),Ee.unbindTexture()},this.initRenderTarget=function(T){We.get(T).__webglFramebuffer===void 0&&je.setupRenderTarget(T)},this.initTexture=function(T){T.isCubeTexture?je.setTextureCube(T,0):T.isData3DTexture?je.setTexture3D(T,0):T.isDataArrayTexture||T.isCompressedArrayTexture?je.setTexture2DArray(T,0):je.setTexture2D(T,0),Ee.unbindTexture()},this.resetState=function(){j=0,z=0,ce=null,Ee.reset(),Me.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Ai}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=St._getDrawingBufferColorSpace(e),t.unpackColorSpace=St._getUnpackColorSpace()}};var Hr=[12399,4410988,8092536,12101998,16705592],fm=13697084;function Iv(i,{top:e,limited:t}){let n=Math.abs(i)/e;if(t&&n>1)return new ot(fm);let s=Math.min(n,1)*(Hr.length-1),r=Math.min(Math.floor(s),Hr.length-2);return new ot(Hr[r]).lerp(new ot(Hr[r+1]),s-r)}var mm={none:"plain",limit:"share of its limit",utilisation:"load over the maker's range",deflection:"deflection at rest",compression:"compression at rest",energy:"strain energy of the mode"};function Nv(i,{verdict:e,check:t,modes:n},s,r){let o=mm[i];switch(i){case"none":return null;case"limit":{let a=e?.cases.find(l=>l.case===s);return Lv(a?.decides===!1?`${o}, not binding in this case`:o,(a?.elements??[]).map(l=>[l.element,l.share??1/0]))}case"utilisation":return Lv(o,pm(t,s).flatMap(a=>a.utilisation===null?[]:[[a.element,a.utilisation]]));case"deflection":return Dv(o,"m",pm(t,s).map(a=>[a.element,a.deflection]));case"compression":return Dv(o,"N",pm(t,s).map(a=>[a.element,a.compression]));case"energy":{let l=n?.modes.find(c=>c.number===r)?.strain_energy_share?.map((c,h)=>[n.elements[h],c])??[];return l.length?{title:o,values:new Map(l),words:Uv,top:Math.max(...l.map(c=>Math.abs(c[1])),1e-12),limited:!1}:null}}}function Ov(i){switch(i){case"none":return"";case"limit":return"No load, force or deflection of a mount has a limit in this file.";case"utilisation":return"No mount of this file has a load range of its maker.";case"energy":return"No mode is shown, or it strains no element.";case"deflection":return"No mount deflects at rest: nothing loads it, or a preload bears the load.";case"compression":return"Nothing loads the mounts at rest: the file has no gravity."}}function pm(i,e){let t=i?.mounts??[],n=t.filter(s=>s.case===e);return n.length?n:t.filter(s=>s.case==="")}var Uv=i=>Number.isFinite(i)?`${He(100*i,3)} %`:"∞",Lv=(i,e)=>e.length?{title:i,values:new Map(e),words:Uv,top:1,limited:!0}:null;function Dv(i,e,t){let n=Math.max(0,...t.map(r=>Math.abs(r[1]))),s=Kl(n,e);return n>0?{title:i,values:new Map(t),words:r=>`${He(r*s.factor,3)} ${s.unit}`,top:n,limited:!1}:null}var Fv=i=>`#${i.toString(16).padStart(6,"0")}`;function kv(i,e,t,n){if(i==="none")return Re;if(!e)return re`<div class="legend">${n||Ov(i)}</div>`;let{title:s,values:r,words:o,top:a,limited:l}=e,c=[...r].reduce((h,u)=>Math.abs(u[1])>Math.abs(h[1])?u:h);return re`<div class="legend" role="img" aria-label="Colours of mounts: ${s}, from 0 to ${o(a)}; largest: ${c[0]}, ${o(c[1])}">
    <b>${s}${t?re` <span class="old">…</span>`:Re}</b>
    <svg viewBox="0 0 150 10" aria-hidden="true">
      <defs><linearGradient id="mount-colours">${Hr.map((h,u)=>so`<stop offset=${u/(Hr.length-1)} stop-color=${Fv(h)}></stop>`)}</linearGradient></defs>
      <rect width=${l?128:150} height="10" fill="url(#mount-colours)"></rect>
      ${l?so`<rect x="134" width="16" height="10" fill=${Fv(fm)}></rect>`:Re}
    </svg>
    <span class=${l?"ticks limited":"ticks"}><span>0</span><span>${o(a)}</span>${l?re`<span>over</span>`:Re}</span>
    <span>most: ${c[0]}, ${o(c[1])}</span></div>`}function gm(i,e){let t=document.createElement("a");t.href=URL.createObjectURL(e),t.download=i,t.click(),URL.revokeObjectURL(t.href)}var td={background:16054008,body:10335432,edge:3690591,mount:3885652,metal:9147804,selected:14711552,force:12859677,rest:6124675,grid:13884128,trace:26012,text:"#24323b"},nd={background:1317149,body:6258070,edge:12177375,mount:10135472,metal:6976893,selected:16757575,force:16747110,rest:9414067,grid:2831419,trace:8177650,text:"#dbe5ec"};function gP(i,e){return[0,3].flatMap(t=>[0,1,2].map(n=>[0,1].map(s=>e.reduce((r,o,a)=>r+o[n]*i[t+a][s],0))))}var _m=i=>[{order:1,amplitudes:i}];function Bs(i,e,t){let[n,s,r,o,a,l]=ym(i,t);return[n+a*e[2]-l*e[1],s+l*e[0]-o*e[2],r+o*e[1]-a*e[0]]}function ym(i,e){let t=[0,0,0,0,0,0];for(let{order:n,amplitudes:s}of i){let r=Math.cos(n*e),o=Math.sin(n*e);s.forEach(([a,l],c)=>{t[c]+=a*r-l*o})}return t}function zv(i,e){let t=new Map;for(let{name:n,axes:s,dofs:r}of i){let o=r.map(a=>e[a]);o.every(a=>a!==void 0)&&t.set(n,_m(gP(o,s)))}return t}var Vv=(i,e)=>new Map(i?.map((t,n)=>[t,_m(e[n])])),Bv=i=>i.map(e=>[e,0]);function Gv(i,e,t){let n=i.modes[e];return n?.shape?{label:`Mode ${n.number}`,words:n.name,angular_frequency:n.angular_frequency,ends:Vv(i.feet,n.feet?.map(Bv)),bodies:zv(t,Bv(n.shape))}:null}function Hv(i,e,t){let n=i.roots.find(s=>s.nearest_mode===e&&s.eigenvalue[1]>0);return n?{label:`Damped mode ${e}`,words:"",angular_frequency:n.eigenvalue[1],ends:Vv(i.feet,n.feet),bodies:zv(t,n.shape)}:null}function Wv(i,e){let t=i.shapes[0];return t?{label:"Operating shape",words:"",angular_frequency:t.angular_frequency,hasSize:!0,...qv(t.places.map(({name:n,motion:s})=>[n,_m(s)]),e)}:null}function $v(i,e,t,n){let s=i.places.map(({name:r,harmonics:o})=>[r,o.map((a,l)=>({order:l,amplitudes:a}))]);return{label:"Steady motion",words:t,angular_frequency:e,hasSize:!0,...qv(s,n)}}function qv(i,e){let t=([n])=>e.some(s=>s.name===n);return{bodies:new Map(i.filter(t)),ends:new Map(i.filter(n=>!t(n)&&_P(n[1])))}}var _P=i=>i.some(({amplitudes:e})=>e.some(([t,n])=>t!==0||n!==0)),xm=i=>Math.max(1,...[...i.bodies.values()].flatMap(e=>e.map(t=>t.order)));function vm(i,e){let t=64*xm(i),n=[0,0,0],s=0,r=(o,a)=>{if(o.length===1&&o[0].order>0)s=Math.max(s,yP(o,a));else for(let l=0;l<t;l++)s=Math.max(s,Math.hypot(...Bs(o,a,2*Math.PI*l/t)))};for(let o of i.ends.values())r(o,n);for(let o of e){let a=i.bodies.get(o.name);if(a)for(let l of bm(o))r(a,l.map((c,h)=>c-o.pole[h]))}return s}function yP(i,e){let[{order:t}]=i,n=Bs(i,e,0),s=Bs(i,e,Math.PI/2/t),r=(l,c)=>l.reduce((h,u,d)=>h+u*c[d],0),o=r(n,n),a=r(s,s);return Math.sqrt((o+a)/2+Math.hypot((o-a)/2,r(n,s)))}function Xv(i,e,t){let n=i.hasSize?vm(i,e):0;return n>0&&t>0?`largest displacement ${ns(n,"m",3)} 0-p, drawn ${He(Number(t.toPrecision(2)),7)} ×`:""}function bm({box:i,pole:e,solids:t}){if(t.length)return t.flatMap(({vertices:s})=>xP(s));if(!i)return[e];let n=[-.5,.5];return n.flatMap(s=>n.flatMap(r=>n.map(o=>[0,1,2].map(a=>i.centre[a]+s*i.size[0]*i.axes[0][a]+r*i.size[1]*i.axes[1][a]+o*i.size[2]*i.axes[2][a]))))}function xP(i){let e=[];for(let t=0;t<3;t++){let[n,s]=[0,0];for(let r=0;r<i.length;r+=3)i[r+t]<i[n+t]&&(n=r),i[r+t]>i[s+t]&&(s=r);for(let r of[n,s])e.push([i[r],i[r+1],i[r+2]])}return e}var id=class{constructor(e,t,n,s=[]){this.body=e;this.object=new Pt;this.atRest=new Pt;this.materials=[];if(this.object.matrixAutoUpdate=this.atRest.matrixAutoUpdate=!1,e.solids.length)for(let r of e.solids)this.add(bP(r.vertices,r.triangles,e.pole),n,.75);else e.box?this.add(vP(e),n,.55):e.node&&this.add(new _l(.006*t,12,8),n);if(s.length){let r=new Nt().setFromPoints(s.flat()).translate(...e.pole.map(o=>-o));this.object.add(new vi(r,new en({color:n.rest})))}this.rest=sa(e.pole,null,0,0),this.atRest.matrix.copy(this.rest),this.move(null,0,0),this.object.traverse(r=>r.userData={kind:"body",name:e.name})}move(e,t,n){this.object.matrix.copy(sa(this.body.pole,e,t,n)),this.object.matrixWorldNeedsUpdate=!0}highlight(e,t){for(let n of this.materials)n.emissive.setHex(e?t.selected:0).multiplyScalar(e?.55:1)}dispose(){Ii(this.object),Ii(this.atRest)}add(e,t,n=1){let s=new Ri({color:t.body,transparent:n<1,opacity:n,depthWrite:n===1,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1}),r=new Fr(e,25);this.materials.push(s),this.object.add(new Mt(e,s),new vi(r,new en({color:t.edge}))),this.atRest.add(new vi(r,new en({color:t.rest,transparent:!0,opacity:.45})))}};function sa(i,e,t,n){let[s,r,o,a,l,c]=e?ym(e,t).map(h=>h*n):[0,0,0,0,0,0];return new yt().set(1,-c,l,i[0]+s,c,1,-a,i[1]+r,-l,a,1,i[2]+o,0,0,0,1)}function Ii(i){i.traverse(e=>{let{geometry:t,material:n}=e;t?.dispose();for(let s of[n].flat())s?.map?.dispose(),s?.dispose()})}function vP({box:i,pole:e}){let t=new Wi(...i.size),[n,s,r]=i.axes,o=i.centre.map((a,l)=>a-e[l]);return t.applyMatrix4(new yt().set(n[0],s[0],r[0],o[0],n[1],s[1],r[1],o[1],n[2],s[2],r[2],o[2],0,0,0,1)),t}function bP(i,e,t){let n=new Nt;n.setAttribute("position",new yi(Float32Array.from(i,(r,o)=>r-t[o%3]),3)),n.setIndex([...e]);let s=n.toNonIndexed();return n.dispose(),s.computeVertexNormals(),s}var jv={edges:"edges at rest",rest:"machine at rest",strobe:"stroboscope"},Yv=8,sd=class{constructor(e,t,n){this.bodies=e;this.elements=t;this.root=new Pt;this.atRest=null;this.flashes=new Pt;this.fill=new Ri({color:n.rest,transparent:!0,opacity:.28,depthWrite:!1}),this.line=new en({color:n.trace,transparent:!0,opacity:.55,depthWrite:!1}),this.root.add(this.flashes)}show(e,t,n){let s=t!==null&&n>0;if(e!=="edges"&&s&&this.root.add(this.atRest??=this.machineAtRest()),this.atRest&&(this.atRest.visible=e!=="edges"&&s),this.flashes.clear(),!(e!=="strobe"||!s))for(let{body:r,atRest:o}of this.bodies){let a=t.bodies.get(r.name);for(let l=0;a&&l<Yv;l++)this.flashes.add(this.flash(o,sa(r.pole,a,2*Math.PI*l/Yv,n)))}}dispose(){this.fill.dispose(),this.line.dispose()}flash(e,t){let n=new Pt;n.matrixAutoUpdate=!1,n.matrix.copy(t),n.matrixWorldNeedsUpdate=!0;for(let s of e.children)n.add(new vi(s.geometry,this.line));return n}machineAtRest(){let e=new Pt;for(let{object:t,rest:n}of[...this.bodies,...this.elements]){let s=t.clone(!0);s.matrix.copy(n),s.matrixWorldNeedsUpdate=!0;for(let r of SP(s))r.userData={},r instanceof Mt?r.material=this.fill:r instanceof vi&&(r.visible=!1);e.add(s)}return e}};function SP(i){let e=[];return i.traverse(t=>e.push(t)),e}function Zv(i,e,{background:t,text:n},s){let r=document.createElement("canvas");[r.width,r.height]=[i.width,i.height];let o=r.getContext("2d");o.drawImage(i,0,0),o.scale(s,s),o.textBaseline="top",o.lineWidth=4,o.lineJoin="round",o.strokeStyle=`#${t.toString(16).padStart(6,"0")}`,o.fillStyle=n;let a=10;return e.forEach((l,c)=>{o.font=`${c?400:650} 15px system-ui, "DejaVu Sans", sans-serif`;for(let h of MP(l,r.width/s-20,u=>o.measureText(u).width))o.strokeText(h,10,a),o.fillText(h,10,a),a+=1.3*15}),r}function MP(i,e,t){let n=[];for(let s of i.split(" ")){let r=n.length?`${n.at(-1)} ${s}`:s;n.length&&t(r)<=e?n[n.length-1]=r:n.push(s)}return n}function Kv(i,{elements:e,points:t,forces:n,size:s}){if(i.node)return[];let r=[...e.flatMap(a=>[a.from,a.to].filter(l=>l.body===i.name).map(l=>l.at)),...t.filter(a=>a.body===i.name).map(a=>a.at),...n.filter(a=>a.body===i.name).map(a=>a.at)],o=new Map;for(let a of r){let l=new I(...a),c=wP(i,l);c.distanceTo(l)>1e-6*s&&o.set(a.join(),[c,l])}return[...o.values()]}function wP({box:i,solids:e,centre_of_mass:t},n){if(e.length){let h=new ti;for(let{vertices:u}of e)for(let d=0;d<u.length;d+=3)h.expandByPoint(new I(...u.slice(d,d+3)));return h.clampPoint(n,new I)}if(!i)return new I(...t);let[s,r,o]=i.axes.map(h=>new I(...h)),a=new yt().makeBasis(s,r,o).setPosition(...i.centre),l=new I(...i.size).multiplyScalar(.5);return n.clone().applyMatrix4(a.clone().invert()).clamp(l.clone().negate(),l).applyMatrix4(a)}var rd=class extends ni{constructor(t,n){super();this.coil=t;this.length=n;this.turns=t.turns+t.dead_turns[0]+t.dead_turns[1]}getPoint(t,n=new I){let{mean_diameter:s,turns:r,dead_turns:[o],left_handed:a,start_angle:l}=this.coil,c=t*this.turns,h=l+(a?-1:1)*2*Math.PI*c,u=Math.min(Math.max((c-o)/r,0),1);return n.set(s/2*Math.cos(h),s/2*Math.sin(h),this.length*u)}};function Jv(i,e,t,n){let s=new Ri({color:n.mount}),r=new Ri({color:n.metal}),o=i.size[1],a=o?o/2:Math.min(Math.max(.45*e,.015*t),.025*t);return(Sm[i.kind]??EP)(i,{length:e,radius:a,rubber:s,metal:r})}var EP=(i,e)=>[new Mt(wm([[1,0],[.86,.25],[.78,.5],[.86,.75],[1,1]],e),e.rubber),...Mm(e)],Sm={coil:({coil:i},e)=>{let t=new rd(i??{mean_diameter:1.7*e.radius,turns:6,dead_turns:[0,0],left_handed:!1,start_angle:0},e.length),n=i?Math.min(i.wire[0],i.wire[1])/2:.12*e.radius;return[new Mt(new xl(t,Math.ceil(24*t.turns),n,8),e.metal)]},rubber:({rubber:i},e)=>{let t=i?.layers??[{thickness:1,metal:!1}],n=t.reduce((r,o)=>r+o.thickness,0),s=0;return t.map(({thickness:r,metal:o})=>{let a=e.length*r/n,l=s+a/2;s+=a;let[c,h]=i?.widths??[],u=c&&h?new Wi(c,h,a).translate(0,0,l):zs((i?.diameter??2*e.radius)/2,a,l);return new Mt(u,o?e.metal:e.rubber)})},bush:({rubber:i},{length:e,radius:t,rubber:n,metal:s})=>{let r=(i?.outer_diameter??2*t)/2,o=(i?.inner_diameter??t)/2;return[new Mt(zs(r,.9*e,e/2),n),new Mt(zs(o,1.15*e,e/2),s)]},beam:({section:i},{length:e,radius:t,metal:n})=>{let[s,r]=i?.widths??[];return[new Mt(s&&r?new Wi(s,r,e).translate(0,0,e/2):zs((i?.outer_diameter??t)/2,e,e/2),n)]},rod:(i,{length:e,radius:t,metal:n})=>[new Mt(zs(.3*t,e,e/2),n)],damper:(i,{length:e,radius:t,rubber:n,metal:s})=>[new Mt(zs(.62*t,.55*e,.3*e),s),new Mt(zs(.24*t,e,.5*e),n)],strut:(i,e)=>[...Sm.coil(i,e),...Sm.damper(i,e)],stop:(i,e)=>[new Mt(wm([[.95,0],[.8,.3],[.25,.62]],e),e.rubber),new Mt(zs(e.radius,.1*e.length,.95*e.length),e.metal)],air_spring:(i,e)=>[new Mt(wm([[.8,0],[1.15,.25],[.85,.5],[1.15,.75],[.8,1]],e),e.rubber),...Mm(e)],wire_rope:(i,e)=>[...[-.5,0,.5].map(t=>{let n=new yl(.45*e.length,.07*e.length,8,24).rotateY(Math.PI/2);return new Mt(n.translate(t*e.radius,0,e.length/2),e.metal)}),...Mm(e)]},zs=(i,e,t)=>new rr(i,i,e,32).rotateX(Math.PI/2).translate(0,0,t),Mm=({radius:i,length:e,metal:t})=>[.03,.97].map(n=>new Mt(zs(1.12*i,.06*e,n*e),t));function wm(i,{radius:e,length:t}){let n=Array.from({length:17},(s,r)=>{let[o,a]=[i[0][1],i.at(-1)[1]],l=o+(a-o)*r/16,c=Math.max(1,i.findIndex(_=>_[1]>=l-1e-9)),[h,u]=i[c-1],[d,f]=i[c],p=(1-Math.cos(Math.PI*(l-u)/(f-u)))/2;return new Se(e*(h+(d-h)*p),t*l)});return new pl(n,32).rotateX(Math.PI/2)}function od(i,e){let t=document.createElement("canvas");t.width=t.height=64,i(t.getContext("2d"),64);let n=new ol(new qo({map:new ll(t),depthTest:!1,sizeAttenuation:!1,transparent:!0,toneMapped:!1}));return n.scale.setScalar(e),n.renderOrder=10,n}function Qv(i){return od((e,t)=>{let n=t/2,s=.4*t;for(let r=0;r<4;r++)e.beginPath(),e.moveTo(n,n),e.arc(n,n,s,r*Math.PI/2,(r+1)*Math.PI/2),e.fillStyle=r%2?"#fff":"#111",e.fill();e.strokeStyle=i.text,e.lineWidth=3,e.beginPath(),e.arc(n,n,s,0,2*Math.PI),e.stroke()},.022)}function eb(){return od((i,e)=>{i.beginPath(),i.arc(e/2,e/2,.42*e,0,2*Math.PI),i.fillStyle="#fff",i.fill(),i.strokeStyle="#111",i.lineWidth=6,i.stroke(),i.font=`700 ${.6*e}px system-ui, sans-serif`,i.textAlign="center",i.textBaseline="middle",i.fillStyle="#111",i.fillText("P",e/2,.53*e)},.024)}function ad({bodies:i,size:e}){let t=(n,s)=>Math.hypot(...n.map((r,o)=>r-s[o]))>1e-6*e;return i.filter(n=>!n.node&&t(n.pole,n.centre_of_mass)&&t(n.pole,[0,0,0]))}function tb(i){return od((e,t)=>{e.beginPath(),e.arc(t/2,t/2,.3*t,0,2*Math.PI),e.fillStyle=`#${i.trace.toString(16).padStart(6,"0")}`,e.fill(),e.strokeStyle="#fff",e.lineWidth=6,e.stroke()},.016)}function TP(i,e){return od((t,n)=>{t.font=`600 ${.7*n}px system-ui, sans-serif`,t.textAlign="center",t.textBaseline="middle",t.fillStyle=e.text,t.fillText(i,n/2,n/2)},.03)}function nb(i,e){let t=new Pt;return["x","y","z"].forEach((n,s)=>{let r=new I().setComponent(s,1),o=TP(n,e);o.scale.setScalar(.45*i),t.add(new Ns(r,new I,i,e.edge,.22*i,.1*i),o),o.position.copy(r).multiplyScalar(1.25*i)}),t}function ib({direction:i,gap:e,kind:t},n,s){let r=new Pt,o=new I(...i),a=e<=0,l=new Hi({color:a?s.force:s.selected,side:Pi,transparent:!0,opacity:.75}),c=.028*n,h=t==="ring"?new gl(c,1.15*c,36):new ul(c,28),u=new Mt(h,l);return u.quaternion.copy(new Mn().setFromUnitVectors(new I(0,0,1),o)),t!=="ring"&&u.position.copy(o).multiplyScalar(Math.max(e,0)),r.add(u),r}function sb({from:i,to:e},t){let n=[new I(...i.at),new I(...e.at)],s=new Ci(new Nt().setFromPoints(n),new en({color:t.selected,depthTest:!1}));return s.renderOrder=7,s}function rb(i,e,t){let n=new Pt,s=.012*i,r=new rr(.045*i,.045*i,s,28).translate(0,-s/2,0);return r.applyQuaternion(new Mn().setFromUnitVectors(new I(0,1,0),e)),n.matrixAutoUpdate=!1,n.add(new Mt(r,new Ri({color:t.rest})),new vi(new Fr(r,25),new en({color:t.edge}))),n}function ob(i,e,t,n,s){let r=10**Math.round(Math.log10(t/6)),o=Math.ceil(2.6*t/r),a=new wl(o*r,o);return a.material.dispose(),a.material=new en({color:s.grid}),a.quaternion.copy(new Mn().setFromUnitVectors(new I(0,1,0),n)),a.position.copy(e).addScaledVector(n,i-e.dot(n)),a}function ab(i,e,t,n,s){let r=i.map((u,d)=>u-e.pole[d]),o=t.bodies.get(e.name),a=[],l=Math.max(72,16*xm(t));for(let u=0;o&&u<=l;u++){let d=Bs(o,r,2*Math.PI*u/l);a.push(...d.map((f,p)=>i[p]+n*f))}let c=new Nt;c.setAttribute("position",new ut(a,3));let h=new Ci(c,new en({color:s.trace,depthTest:!1}));return h.renderOrder=9,h}var ld=class{constructor(e,t,n,s,r){this.element=e;this.object=new Pt;this.object.matrixAutoUpdate=!1;let[o,a,l]=e.axes.map(_=>new I(..._)),c=new I(...e.from.at),h=new I(...e.to.at),u=e.rubber?.length;if(u)lb(c,h,l,u/2,u/2);else if(c.distanceTo(h)<.01*n){let _=Math.min(Math.max(e.size[0],.07*n),.12*n),m=l.clone().multiplyScalar(AP(e,t,l));e.from.body&&e.to.body?lb(c,h,l,_/2,_/2):e.from.body?h.addScaledVector(m,_):c.addScaledVector(m,_)}this.ends={from:c,to:h},this.length=Math.max(c.distanceTo(h),1e-9);let d=h.clone().sub(c).normalize(),f=Math.abs(d.dot(l))>.99,p=f?o:new I().crossVectors(Math.abs(d.x)<.9?new I(1,0,0):new I(0,1,0),d).normalize();this.across=[p,f&&d.dot(l)>0?a:d.clone().cross(p)],this.object.add(...Jv(e,this.length,n,r)),this.object.traverse(_=>_.userData={kind:"element",name:e.name}),this.place(c,h),this.rest=this.object.matrix.clone(),this.foot=e.from.body?null:rb(n,s,r),this.foot&&this.foot.traverse(_=>_.userData={kind:"element",name:e.name}),this.move(null,t,0,0)}move(e,t,n,s){let{element:{from:r,to:o,name:a},ends:l,foot:c}=this;if(this.place(cb(l.from,r,e,t,n,s,`${a}.foot`),cb(l.to,o,e,t,n,s,`${a}.head`)),!c)return;let h=e?.ends.get(`${a}.foot`)??null,{x:u,y:d,z:f}=l.from;for(let p of c.children)p.visible=r.foundation!==void 0||h!==null;c.matrix.copy(sa([u,d,f],h,n,s)),c.matrixWorldNeedsUpdate=!0}highlight(e,t){this.object.traverse(n=>{n.material?.emissive?.setHex(e?t.selected:0).multiplyScalar(e?.7:1)})}paint(e){this.object.traverse(t=>{let n=t.material;if(!n?.color)return;let s=n.userData.own??=n.color.clone();n.color.copy(e??s)})}dispose(){Ii(this.object),this.foot&&Ii(this.foot)}place(e,t){let n=t.clone().sub(e).divideScalar(this.length),[s,r]=this.across;this.object.matrix.copy(new yt().makeBasis(s,r,n).setPosition(e)),this.object.matrixWorldNeedsUpdate=!0}},lb=(i,e,t,n,s)=>{i.addScaledVector(t,-n),e.addScaledVector(t,s)};function cb(i,e,t,n,s,r,o){if(!t)return i;let a=n.get(e.body??""),l=a?t.bodies.get(a.name):t.ends.get(o);if(!l)return i;let c=a?e.at.map((h,u)=>h-a.pole[u]):[0,0,0];return i.clone().addScaledVector(new I(...Bs(l,c,s)),r)}function AP({from:i,to:e},t,n){let s=t.get(e.body??"")??t.get(i.body??""),r=s?n.dot(new I(...e.at).sub(new I(...s.centre_of_mass))):0;return r>1e-9?1:r<-1e-9||n.z>0?-1:1}function hb(i,e,t){let n=new I(...i.direction);n.lengthSq()===0&&n.set(0,0,1),n.normalize();let s=i.kind==="force"||i.kind==="ground_translation"?CP(n,e,t.force):Em(n,(i.kind==="rotating_force"?.05:.09)*e,t.force);return s.traverse(r=>{r.userData={kind:"force",name:i.name},r.renderOrder=8;let o=r.material;o&&(o.depthTest=!1)}),s}function CP(i,e,t){let n=new Pt,s=.18*e;return n.add(new Ns(i,i.clone().multiplyScalar(-s),s,t,.04*e,.022*e)),n}function Em(i,e,t){let n=new Pt,s=1.55*Math.PI,r=Array.from({length:41},(a,l)=>new I(e*Math.cos(s*l/40),e*Math.sin(s*l/40),0)),o=new Mt(new Xo(.2*e,.5*e,14),new Hi({color:t}));return o.position.copy(r.at(-1)),o.rotation.z=s,n.add(new Ci(new Nt().setFromPoints(r),new en({color:t})),o),n.quaternion.copy(new Mn().setFromUnitVectors(new I(0,0,1),i)),n}function ub({direction:i,point:e,pitch:t},n,s,r){let o=new Pt,a=new I(...i),l=e?new I(...e):n;if(e){let u=[-.6,.6].map(f=>l.clone().addScaledVector(a,f*s)),d=Em(a,.09*s,r.selected);d.position.copy(l),o.add(new Ci(new Nt().setFromPoints(u),new en({color:r.selected})),d)}let c=a.clone().multiplyScalar(t!==null&&t<0?-1:1),h=e?.14*s:.3*s;return(!e||Math.abs(t??0)>.001*s)&&o.add(new Ns(c,l,h,r.selected,.05*s,.026*s)),o.traverse(u=>{u.renderOrder=9;let d=u.material;d&&(d.depthTest=!1)}),o}function db(i,e){Ii(i),i.clear(),e&&i.add(e)}function Wr(i){i.traverse(e=>{let{geometry:t,material:n}=e;for(let s of[n??[]].flat())!s.transparent&&s.blending===dr&&(s.blending=Os),(s instanceof Hi||s instanceof en)&&(t?.deleteAttribute("normal"),Object.assign(s,{combine:Qo}))})}var cd=class{constructor(e,t){this.scene=e;this.colours=t;this.root=new Pt;this.bounds=new ti;this.followers=[];this.rest=new Pt;this.traces=new Pt;this.screw=new Pt;let n=e.gravity&&Math.hypot(...e.gravity)>0?new I(...e.gravity).negate().normalize():new I(0,0,1);this.byName=new Map(e.bodies.map(o=>[o.name,o])),this.bodies=e.bodies.map(o=>new id(o,e.size,t,Kv(o,e))),this.elements=e.elements.map(o=>new ld(o,this.byName,e.size,n,t)),this.ghosts=new sd(this.bodies,this.elements,t);for(let{object:o,atRest:a}of this.bodies)this.root.add(o),this.rest.add(a);for(let{object:o,foot:a}of this.elements)this.root.add(o,...a?[a]:[]);this.root.add(this.rest,this.traces,this.ghosts.root,this.screw);for(let o of e.bodies.filter(a=>!a.node))this.follow(Qv(t),o,o.centre_of_mass,{kind:"body",name:o.name});for(let o of ad(e))this.follow(eb(),o,o.pole,{kind:"body",name:o.name,words:`pole of ${o.name}`});for(let o of e.points){let a=this.byName.get(o.body);a&&this.follow(tb(t),a,o.at,{kind:"point",name:o.name})}for(let o of e.forces){let a=this.byName.get(o.body??""),l=hb(o,e.size,t);l.position.set(...o.at),a?this.follow(l,a,o.at,{kind:"force",name:o.name}):this.root.add(l)}for(let o of e.stops){let a=ib(o,e.size,t);a.position.set(...o.at),a.traverse(l=>l.userData={kind:"element",name:o.name}),this.root.add(a)}for(let o of e.clearances)this.root.add(sb(o,t));this.root.updateMatrixWorld(!0),this.measure();let s=this.bounds.getCenter(new I),r=RP(this.bounds,n);this.root.add(ob(r,s,e.size,n,t)),Wr(this.root)}scaleFor(e,t){let n=vm(e,this.scene.bodies);return n>0?t*this.scene.size/n:0}move(e,t,n){for(let s of this.bodies)s.move(e?.bodies.get(s.body.name)??null,t,n);for(let s of this.elements)s.move(e,this.byName,t,n);for(let{object:s,body:r,at:o,rest:a}of this.followers){let l=e?.bodies.get(r.name),c=o.map((h,u)=>h-r.pole[u]);s.position.copy(a),l&&s.position.addScaledVector(new I(...Bs(l,c,t)),n)}this.rest.visible=e!==null&&n>0}showTraces(e,t){if(Ii(this.traces),this.traces.clear(),!!e){for(let n of this.scene.bodies){let s=this.scene.points.filter(r=>r.body===n.name).map(r=>r.at);for(let r of[...s,n.centre_of_mass,...bm(n).slice(-4)])this.traces.add(ab(r,n,e,t,this.colours))}Wr(this.traces)}}showGhosts(e,t,n){this.ghosts.show(e,t,n),Wr(this.ghosts.root)}showScrew(e,t){db(this.screw,e&&t&&ub(e,new I(...t.centre_of_mass),this.scene.size,this.colours)),Wr(this.screw)}highlight(e){for(let t of this.bodies)t.highlight(e?.kind==="body"&&e.name===t.body.name,this.colours);for(let t of this.elements)t.highlight(e?.kind==="element"&&e.name===t.element.name,this.colours)}colour(e){for(let t of this.elements){let n=e?.values.get(t.element.name);t.paint(n===void 0?null:Iv(n,e))}}dispose(){Ii(this.root),this.ghosts.dispose()}follow(e,t,n,s){let r=new I(...n);e.position.copy(r),e.traverse(o=>o.userData=s),this.followers.push({object:e,body:t,at:n,rest:r}),this.root.add(e)}measure(){for(let{object:e}of[...this.bodies,...this.elements])this.bounds.expandByObject(e);for(let{rest:e}of this.followers)this.bounds.expandByPoint(e);this.bounds.isEmpty()&&this.bounds.expandByPoint(new I)}},RP=({min:i,max:e},t)=>[0,1,2].reduce((n,s)=>{let r=t.getComponent(s);return n+r*(r>0?i:e).getComponent(s)},0);var fb={type:"change"},Am={type:"start"},mb={type:"end"},hd=new ir,pb=new _i,PP=Math.cos(70*Kp.DEG2RAD),An=new I,si=2*Math.PI,It={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Tm=1e-6,ud=class extends El{constructor(e,t=null){super(e,t),this.state=It.NONE,this.target=new I,this.cursor=new I,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:cr.ROTATE,MIDDLE:cr.DOLLY,RIGHT:cr.PAN},this.touches={ONE:hr.ROTATE,TWO:hr.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new I,this._lastQuaternion=new Mn,this._lastTargetPosition=new I,this._quat=new Mn().setFromUnitVectors(e.up,new I(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new Ko,this._sphericalDelta=new Ko,this._scale=1,this._panOffset=new I,this._rotateStart=new Se,this._rotateEnd=new Se,this._rotateDelta=new Se,this._panStart=new Se,this._panEnd=new Se,this._panDelta=new Se,this._dollyStart=new Se,this._dollyEnd=new Se,this._dollyDelta=new Se,this._dollyDirection=new I,this._mouse=new Se,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=LP.bind(this),this._onPointerDown=IP.bind(this),this._onPointerUp=DP.bind(this),this._onContextMenu=zP.bind(this),this._onMouseWheel=UP.bind(this),this._onKeyDown=FP.bind(this),this._onTouchStart=kP.bind(this),this._onTouchMove=BP.bind(this),this._onMouseDown=NP.bind(this),this._onMouseMove=OP.bind(this),this._interceptControlDown=VP.bind(this),this._interceptControlUp=GP.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(e){this._cursorStyle=e,e==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=It.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(fb),this.update(),this.state=It.NONE}pan(e,t){this._pan(e,t),this.update()}dollyIn(e){this._dollyIn(e),this.update()}dollyOut(e){this._dollyOut(e),this.update()}rotateLeft(e){this._rotateLeft(e),this.update()}rotateUp(e){this._rotateUp(e),this.update()}update(e=null){let t=this.object.position;An.copy(t).sub(this.target),An.applyQuaternion(this._quat),this._spherical.setFromVector3(An),this.autoRotate&&this.state===It.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(n)&&isFinite(s)&&(n<-Math.PI?n+=si:n>Math.PI&&(n-=si),s<-Math.PI?s+=si:s>Math.PI&&(s-=si),n<=s?this._spherical.theta=Math.max(n,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+s)/2?Math.max(n,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(An.setFromSpherical(this._spherical),An.applyQuaternion(this._quatInverse),t.copy(this.target).add(An),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=An.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new I(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new I(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=An.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(hd.origin.copy(this.object.position),hd.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(hd.direction))<PP?this.object.lookAt(this.target):(pb.setFromNormalAndCoplanarPoint(this.object.up,this.target),hd.intersectPlane(pb,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Tm||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Tm||this._lastTargetPosition.distanceToSquared(this.target)>Tm?(this.dispatchEvent(fb),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?si/60*this.autoRotateSpeed*e:si/60/60*this.autoRotateSpeed}_getZoomScale(e){let t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){An.setFromMatrixColumn(t,0),An.multiplyScalar(-e),this._panOffset.add(An)}_panUp(e,t){this.screenSpacePanning===!0?An.setFromMatrixColumn(t,1):(An.setFromMatrixColumn(t,0),An.crossVectors(this.object.up,An)),An.multiplyScalar(e),this._panOffset.add(An)}_pan(e,t){let n=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;An.copy(s).sub(this.target);let r=An.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*r/n.clientHeight,this.object.matrix),this._panUp(2*t*r/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),s=e-n.left,r=t-n.top,o=n.width,a=n.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientY),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(si*this._rotateDelta.x/t.clientHeight),this._rotateUp(si*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(si*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-si*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(si*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-si*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._rotateStart.set(n,s)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panStart.set(n,s)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(n*n+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let n=this._getSecondPointerPosition(e),s=.5*(e.pageX+n.x),r=.5*(e.pageY+n.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(si*this._rotateDelta.x/t.clientHeight),this._rotateUp(si*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panEnd.set(n,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(n*n+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(e.pageX+t.x)*.5,a=(e.pageY+t.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new Se,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,n={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function IP(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function LP(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function DP(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(mb),this.state=It.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function NP(i){let e;switch(i.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case cr.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=It.DOLLY;break;case cr.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=It.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=It.ROTATE}break;case cr.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=It.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=It.PAN}break;default:this.state=It.NONE}this.state!==It.NONE&&this.dispatchEvent(Am)}function OP(i){switch(this.state){case It.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case It.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case It.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function UP(i){this.enabled===!1||this.enableZoom===!1||this.state!==It.NONE||(i.preventDefault(),this.dispatchEvent(Am),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent(mb))}function FP(i){this.enabled!==!1&&this._handleKeyDown(i)}function kP(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case hr.ROTATE:if(this.enableRotate===!1){this.state=It.NONE;break}this._handleTouchStartRotate(i),this.state=It.TOUCH_ROTATE;break;case hr.PAN:if(this.enablePan===!1){this.state=It.NONE;break}this._handleTouchStartPan(i),this.state=It.TOUCH_PAN;break;default:this.state=It.NONE}break;case 2:switch(this.touches.TWO){case hr.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=It.TOUCH_DOLLY_PAN;break;case hr.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=It.TOUCH_DOLLY_ROTATE;break;default:this.state=It.NONE}break;default:this.state=It.NONE}this.state!==It.NONE&&this.dispatchEvent(Am)}function BP(i){switch(this._trackPointer(i),this.state){case It.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case It.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case It.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case It.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=It.NONE}}function zP(i){this.enabled!==!1&&i.preventDefault()}function VP(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function GP(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var Cm=[3,6,9],gb=12;function _b(i,e,t,n){i.updateMatrixWorld();let s=new Ml,r=[],o=e.position.distanceTo(new I().setFromMatrixPosition(i.matrixWorld)),a=2*o*Math.tan(e.fov*Math.PI/360)/n.y;s.params.Line.threshold=Cm[0]*a,i.traverseVisible(S=>{S.userData.kind&&!S.isLineSegments&&r.push(S)});let l=S=>S.isSprite===!0,c=S=>S.userData.kind==="body"&&Rm(S)>Cm[2]*a,h=(S,y)=>s.setFromCamera(new Se(t.x+2*S/n.x,t.y+2*y/n.y),e),u=S=>s.intersectObjects(S,!1)[0],d=S=>S?S.userData:null;h(0,0);let f=r.filter(l),p=r.filter(S=>!l(S)&&!c(S)),_=r.filter(c),m=S=>S.isLine===!0,g=p.filter(S=>!m(S)),x=u(f)??u(g)??u(p.filter(m));if(x)return d(x.object);for(let S of Cm){let y=[];for(let U=0;U<gb;U++){let N=2*Math.PI*U/gb;h(S*Math.cos(N),S*Math.sin(N));let L=u(g)??u(f.filter(V=>V.userData.kind!=="body"));L&&y.push(L)}let M=y.sort((U,N)=>U.distance-N.distance)[0];if(M)return d(M.object)}h(0,0);let b=i.children.filter(S=>S.visible&&S.userData.kind==="element").map(S=>({part:S,distance:HP(S,s)})).filter(({distance:S})=>S<1/0).sort((S,y)=>S.distance-y.distance)[0];if(b)return d(b.part);let A=s.intersectObjects(_,!1).sort((S,y)=>Rm(S.object)-Rm(y.object)||S.distance-y.distance);return d(A[0]?.object)}function Rm(i){let{geometry:e}=i;return e?(e.boundingSphere||e.computeBoundingSphere(),e.boundingSphere.radius):0}function HP(i,{ray:e}){let t=new ti,n=new yt().copy(i.matrixWorld).invert();i.traverseVisible(r=>{let{geometry:o}=r;o&&(o.boundingBox||o.computeBoundingBox(),t.union(o.boundingBox.clone().applyMatrix4(new yt().multiplyMatrices(n,r.matrixWorld))))});let s=e.clone().applyMatrix4(n).intersectBox(t,new I);return s?s.applyMatrix4(i.matrixWorld).distanceTo(e.origin):1/0}var WP={oblique:[.75,-1,.55],front:[0,-1,0],side:[1,0,0],top:[0,0,1]},$P=8,Pm=.05,Im=.5,qP=4,dd=class{constructor(e,t,n){this.beforeFrame=n;this.camera=new Zn(28,1,.01,100);this.scene=new $o;this.light=new jo(16777215,2);this.machine=null;this.corner=new $o;this.cornerCamera=new kr(-1.6,1.6,1.6,-1.6,.1,10);this.wanted=!1;this.isBehind=!1;this.isMeasuring=!1;this.isDisposed=!1;this.share=Im;this.taken={until:0,time:0};this.renderer=new Ju({canvas:e,antialias:!0}),this.renderer.setPixelRatio(Math.min(devicePixelRatio,2)),this.renderer.setClearColor(t),this.camera.up.set(0,0,1),this.controls=new ud(this.camera,e),this.controls.addEventListener("change",()=>this.draw()),this.scene.add(new Yo(16777215,8952234,1.6),this.light)}show(e,t,n){this.machine&&this.scene.remove(this.machine.root),this.machine?.dispose(),this.machine=e,this.scene.add(e.root),this.renderer.setClearColor(t.background),Ii(this.corner),this.corner.clear(),this.corner.add(nb(1,t),new Yo,new jo),Wr(this.corner),n&&this.look("oblique"),this.draw()}look(e){if(!this.machine)return;let t=this.machine.bounds.getBoundingSphere(new Ls),n=t.radius*this.reach(),s=new I(...WP[e]).normalize();e==="top"&&s.add(new I(0,-.001,0)),this.controls.target.copy(t.center),this.camera.position.copy(t.center).addScaledVector(s,n),[this.camera.near,this.camera.far]=[n/50,n*20],this.camera.updateProjectionMatrix(),this.controls.update(),this.draw()}turn(e,t,n=1){let{target:s}=this.controls,r=this.camera.position.clone().sub(s).multiplyScalar(n),o=new I().crossVectors(this.camera.up,r).normalize();r.applyAxisAngle(this.camera.up,e);let a=r.angleTo(this.camera.up);a-t>.05&&a-t<Math.PI-.05&&r.applyAxisAngle(o.applyAxisAngle(this.camera.up,e),-t),this.camera.position.copy(s).add(r),this.controls.update(),this.draw()}reach(){let e=this.camera.fov*Math.PI/360,t=Math.min(e,Math.atan(Math.tan(e)*this.camera.aspect));return 1.02/Math.sin(t)}resize(e,t){if(e<1||t<1)return;this.renderer.setSize(e,t,!1);let n=this.reach();this.camera.aspect=e/t,this.camera.updateProjectionMatrix();let s=this.camera.position.clone().sub(this.controls.target).multiplyScalar(this.reach()/n);this.camera.position.copy(this.controls.target).add(s),this.draw()}draw(){this.isBehind=!1,!this.wanted&&(this.wanted=!0,requestAnimationFrame(()=>{this.wanted=!1,this.isDisposed||this.drawNow()}))}drawWhenFree(e){this.isBehind=!0,this.share=e,!(this.isMeasuring||this.later!==void 0)&&(this.later=setTimeout(()=>{this.later=void 0,this.draw(),this.isMeasuring=!0,requestAnimationFrame(()=>this.isDisposed||this.measure(performance.now()))},Math.max(0,this.taken.until+this.taken.time*(1/e-1)-performance.now())))}measure(e){let t=this.renderer.getContext(),n=t.fenceSync(t.SYNC_GPU_COMMANDS_COMPLETE,0);t.flush();let s=()=>{if(this.isDisposed)return;if(n&&!t.isContextLost()&&t.clientWaitSync(n,0,0)===t.TIMEOUT_EXPIRED)return void setTimeout(s,qP);t.deleteSync(n);let r=performance.now(),o=r-e;this.taken={until:r,time:o<$P?0:o},this.isMeasuring=!1,this.isBehind&&this.drawWhenFree(this.share)};s()}drawNow(){this.beforeFrame(),this.light.position.copy(this.camera.position).add(new I(0,0,this.camera.position.length())),this.renderer.render(this.scene,this.camera),this.drawCorner()}drawCorner(){let{x:t}=this.renderer.getSize(new Se);this.cornerCamera.up.copy(this.camera.up),this.cornerCamera.position.copy(this.camera.position).sub(this.controls.target).setLength(5),this.cornerCamera.lookAt(0,0,0),this.renderer.autoClear=!1,this.renderer.setViewport(t-84,0,84,84),this.renderer.clearDepth(),this.renderer.render(this.corner,this.cornerCamera),this.renderer.setViewport(0,0,t,this.renderer.getSize(new Se).y),this.renderer.autoClear=!0}pick(e,t){return this.machine&&_b(this.machine.root,this.camera,new Se(e,t),this.renderer.getSize(new Se))}dispose(){this.isDisposed=!0,clearTimeout(this.later),this.machine?.dispose(),this.controls.dispose(),this.renderer.dispose()}};function yb(i,e,t){let n=i.modes.find(o=>o.number===e)?.screws?.[i.bodies.indexOf(t.name)];if(!n||Math.hypot(...n.direction)===0)return null;let s=o=>[0,1,2].map(a=>t.axes.reduce((l,c,h)=>l+c[a]*o[h],0)),r=n.point&&s(n.point).map((o,a)=>o+t.pole[a]);return{direction:s(n.direction),point:r,pitch:n.pitch}}function xb({point:i,pitch:e},{centre_of_mass:t}){if(!i)return"translation without rotation";let n=Math.hypot(...i.map((s,r)=>s-t[r]));return`screw axis ${ns(n,"m",3)} from the centre of mass, pitch ${ns(Math.abs(e)<1e-9?0:e,"m",3)}/rad`}var XP=1e-9;function YP(i,e){if(i.over!=="frequency")return!1;let t=i.points.map(n=>n.angular_frequency);return e>=Math.min(...t)&&e<=Math.max(...t)}function fd(i,e){return i?.at?.find(t=>Math.abs(t.angular_frequency-e)<=XP*e)?.motions??null}function Lm({stable:i,periods:e}){let t=Ca({stable:i});return e>1?`${t}, ${e} periods`:t}function jP(i){let e=n=>n.results[0]?n.results[0].largest-n.results[0].smallest:0,t=i.over==="frequency"?i.points.filter(n=>n.stable):[];return t.length?t.reduce((n,s)=>e(s)>e(n)?s:n).angular_frequency:null}function vb(i,e){return fd(i.result("steady"),e)?"no such steady motion is known here":i.failure("steady")||"steady motion: computing …"}function Dm(i,{shown:e,frequencyUnit:t}){if(!i)return[];let n="omega"in e&&YP(i,e.omega)?e.omega:jP(i);if(n===null)return[];let s=is(n,t),r=fd(i,n);return r?r.map((o,a)=>({omega:n,motion:a,words:`steady motion${r.length>1?` ${a+1}`:""} at ${s}, ${Lm(o)}`})):[{omega:n,motion:0,words:`steady motion at ${s}`}]}var pd=class{constructor(){this.from=[];this.motion=null}of({asker:e,display:{shown:t,damped:n}}){let s=e.result("scene"),r=e.result("modes"),o=n?e.result("roots"):null,a=t.kind==="frequency"?e.result("shapes"):null,l=t.kind==="steady"?e.result("steady"):null,c=[t,s,r,o,a,l];if(c.every((u,d)=>u===this.from[d])&&this.from.length)return this.motion;this.from=c;let h=s?.bodies??[];if(t.kind==="steady"){let u=fd(l,t.omega),d=u?.[t.motion];this.motion=d?$v(d,t.omega,`${u.length>1?`${t.motion+1} of ${u.length}, `:""}${Lm(d)}`,h):null}else if(t.kind==="frequency")this.motion=a&&Wv(a,h);else if(t.kind==="rest"||!r)this.motion=null;else{let u=r.modes.findIndex(f=>f.number===t.number),d=o&&Hv(o,t.number,h);this.motion=d?{...d,words:r.modes[u]?.name??""}:Gv(r,u,h)}return this.motion}};var ZP={rgb:0,bt709:1,bt470bg:5,smpte170m:6},KP={bt709:1,smpte170m:6,"iec61966-2-1":13},JP={bt709:1,bt470bg:5,smpte170m:6},Nm=2;function bb(i){let{frames:e,frameDuration:t}=i,n=Et(440786851,Et(17030,cn(1)),Et(17143,cn(1)),Et(17138,cn(4)),Et(17139,cn(8)),Et(17026,md("webm")),Et(17031,cn(4)),Et(17029,cn(2))),s=Et(357149030,Et(2807729,cn(1e6)),Et(17545,nI(e.length*t)),Et(19840,md("Trivet")),Et(22337,md("Trivet")));return Sb([n,Et(408125543,s,QP(i),...tI(i))])}var QP=({codec:i,width:e,height:t,frameDuration:n,colours:s})=>Et(374648427,Et(174,Et(215,cn(1)),Et(29637,cn(1)),Et(131,cn(1)),Et(156,cn(0)),Et(134,md(i)),Et(2352003,cn(n*1e6)),Et(224,Et(176,cn(e)),Et(186,cn(t)),eI(s)))),eI=({matrix:i,transfer:e,primaries:t,fullRange:n})=>Et(21936,Et(21937,cn(ZP[i??""]??Nm)),Et(21945,cn(n?2:1)),Et(21946,cn(KP[e??""]??Nm)),Et(21947,cn(JP[t??""]??Nm)));function tI({frames:i,frameDuration:e}){let t=[];return i.forEach(({data:n,key:s},r)=>{let o=r*e;(s||o-t.at(-1).begin>32767)&&t.push({begin:o,blocks:[]});let{begin:a,blocks:l}=t.at(-1),c=o-a;l.push(Et(163,Uint8Array.of(129,c>>8,c&255,s?128:0),n))}),t.map(({begin:n,blocks:s})=>Et(524531317,Et(231,cn(n)),...s))}function Et(i,...e){let t=cn(e.reduce((s,r)=>s+r.length,0)),n=new Uint8Array(8);return n[0]=1,n.set(t,8-t.length),Sb([cn(i),n,...e])}function cn(i){let e=[];do e.unshift(i%256),i=Math.floor(i/256);while(i>0);return Uint8Array.from(e)}function nI(i){let e=new Uint8Array(8);return new DataView(e.buffer).setFloat64(0,i),e}var md=i=>new TextEncoder().encode(i);function Sb(i){let e=new Uint8Array(i.reduce((n,s)=>n+s.length,0)),t=0;for(let n of i)e.set(n,t),t+=n.length;return e}function Om(i){let e=Math.max(24,Math.round(30*i));return{count:e,frameDuration:Math.max(1,Math.round(1e3*i/e))}}var Um=()=>typeof VideoEncoder<"u",iI=[{codec:"vp8",name:"V_VP8"},{codec:"vp09.00.41.08",name:"V_VP9"}];async function Mb(i,e,t){let{count:n,frameDuration:s}=Om(e),r=_=>_-_%2;t(0);let[o,a]=[r(i.width),r(i.height)],l={width:o,height:a,framerate:1e3/s,bitrate:Math.max(2e6,.15*o*a*1e3/s)},c=await sI(l);if(!c)throw new Error("This browser encodes neither VP8 nor VP9.");let h=[],u=null,d={},f=new VideoEncoder({output:(_,m)=>{d=m?.decoderConfig?.colorSpace??d;let g=new Uint8Array(_.byteLength);_.copyTo(g),h.push({data:g,key:_.type==="key"})},error:_=>{u=_}});f.configure({...l,codec:c.codec});for(let _=0;_<n&&!u;_++){t(_/n);let m=new VideoFrame(i,{timestamp:1e3*_*s,duration:1e3*s,alpha:"discard",visibleRect:{x:0,y:0,width:o,height:a}});for(f.encode(m,{keyFrame:_===0}),m.close();f.encodeQueueSize>2;)await new Promise(g=>setTimeout(g,4))}if(u||await f.flush(),u)throw u;f.close();let p={codec:c.name,width:o,height:a,frameDuration:s,frames:h,colours:d};return bb(p)}async function sI(i){for(let e of iI)if((await VideoEncoder.isConfigSupported({...i,codec:e.codec})).supported)return e;return null}var rI={ArrowLeft:[-.15,0,1],ArrowRight:[.15,0,1],ArrowUp:[0,.12,1],ArrowDown:[0,-.12,1],"+":[0,0,.8695652173913044],"-":[0,0,1.15]};function wb(i,{display:e,asker:t,state:n},s){if(i.ctrlKey||i.metaKey||i.altKey)return;let r=rI[i.key],o=t.result("modes")?.modes.length??0,a=e.shown.kind==="mode"?e.shown.number:0;if(r)s?.turn(...r);else if(i.key==="Home")s?.look("oblique");else if(i.key===" ")e.set({playing:!e.playing});else if(i.key==="n"&&o)e.set({shown:{kind:"mode",number:Math.min(a+1,o)}});else if(i.key==="p"&&o)e.set({shown:{kind:"mode",number:Math.max(a-1,1)}});else if(i.key==="s")n.select(oI(t.result("scene"),n.selection));else return;i.preventDefault()}function oI(i,e){if(!i)return null;let t=[...i.bodies.map(s=>({kind:"body",name:s.name})),...i.elements.map(s=>({kind:"element",name:s.name}))],n=t.findIndex(s=>s.kind===e?.kind&&s.name===e.name);return t[n+1]??null}var Fm=class extends vn{constructor(){super(...arguments);this.stage=null;this.machine=null;this.drawn={scene:null,key:""};this.shownMotion=new pd;this.sized=[];this.traced=[];this.marked=[];this.pictured={hand:[],numbers:[]};this.fitted=null;this.motion=null;this.scale=0;this.last=0;this.watcher=null;this.hovered="";this.recording=!1;this.down=[0,0]}render(){let{display:t,asker:n,state:s}=this.app,r=n.result("modes"),{shown:o}=t,a=Dm(n.result("steady"),t),l=o.kind==="mode"?`${o.number}`:o.kind==="steady"?`steady ${o.motion}`:o.kind,c=this.label(),[h,u]=this.screw(),d=o.kind==="steady"?"steady":o.kind==="frequency"?"shapes":"modes",f=["oblique","front","side","top"];return re`
      <div class="stage ${n.isOutdated("scene")?"outdated":""}" tabindex="0" role="application" aria-label="Machine in 3D: ${c}. Arrow keys turn it, plus and minus zoom, space plays or stops, n and p show the next and the previous mode, s selects the next part."
           @keydown=${p=>wb(p,this.app,this.stage)}>
        <canvas class="machine" @pointerdown=${this.pressed} @pointerup=${this.released} @pointermove=${this.moved}></canvas>
        <div class="caption" aria-hidden="true">${c}${n.isOld(d)?re` <span class="old">…</span>`:Re}</div>
        ${n.isOutdated("scene")?oo:Re}
        ${this.legend()}
        ${this.poleLegend()}
        <div class="hover" aria-hidden="true">${this.hovered||s.selection?.name||""}${h&&!this.hovered?re` · ${xb(h,u)}`:Re}</div>
        ${n.result("scene")?Re:re`<p class="missing">${n.missing("scene")}</p>`}
      </div>
      <div class="bar">
        <button class="play" aria-pressed=${t.playing} title="Play or stop (space)" @click=${()=>t.set({playing:!t.playing})}>
          ${t.playing?"❚❚":"▶"}<span class="hidden">${t.playing?"Stop":"Play"}</span></button>
        <select aria-label="Motion" .value=${l} @change=${this.choose}>
          ${r?.modes.map(p=>re`<option value=${p.number} ?selected=${l===`${p.number}`}>${p.number} · ${is(p.angular_frequency,t.frequencyUnit)} · ${p.name}</option>`)}
          ${"omega"in o?re`<option value="frequency" ?selected=${l==="frequency"}>operating shape at ${is(o.omega,t.frequencyUnit)}</option>`:Re}
          ${a.map(p=>re`<option value="steady ${p.motion}" ?selected=${l===`steady ${p.motion}`}>${p.words}</option>`)}
          <option value="rest" ?selected=${l==="rest"}>at rest</option>
        </select>
      </div>
      <div class="bar">
        <span class="views" role="group" aria-label="View">${f.map(p=>re`<button @click=${()=>this.stage?.look(p)}>${p}</button>`)}</span>
        <button title="Save the picture as PNG" @click=${this.savePicture}>PNG</button>
        <button title=${Um()?"Save a video of exactly one period (WebM)":"This browser cannot encode videos (WebCodecs)"} ?disabled=${!Um()||!this.motion||this.recording}
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
          ${Object.entries(jv).map(([p,_])=>re`<option value=${p} ?selected=${p===t.ghost}>${_}</option>`)}</select></label>
        <label class="chosen">mounts <select aria-label="Colour of mounts" @change=${p=>t.set({colouring:p.target.value})}>
          ${Object.entries(mm).map(([p,_])=>re`<option value=${p} ?selected=${p===t.colouring}>${_}</option>`)}</select></label>
      </div>`}label(){let{display:{shown:t,frequencyUnit:n,share:s},asker:r}=this.app,{motion:o}=this;if(!o)return t.kind==="steady"?vb(r,t.omega):"at rest";let a=`${o.label}, ${is(o.angular_frequency,n)}${o.words?`: ${o.words}`:""}`,l=this.machine?Xv(o,this.machine.scene.bodies,this.machine.scaleFor(o,s)):"";return l?`${a} · ${l}`:a}firstUpdated(){let t=this.querySelector("canvas");this.stage=new dd(t,(this.app.display.theme==="dark"?nd:td).background,()=>this.frame()),this.watcher=new ResizeObserver(()=>this.stage.resize(t.clientWidth,t.clientHeight)),this.watcher.observe(t.parentElement),this.stage.resize(t.clientWidth,t.clientHeight),this.updated()}updated(){let{asker:t,display:n}=this.app,s=t.result("scene");if(!this.stage||!s)return;let r=n.theme==="dark"?nd:td;if(s!==this.drawn.scene||!this.drawn.key.startsWith(n.theme)){let a=n.theme+JSON.stringify(s);a!==this.drawn.key&&(this.machine=new cd(s,r),this.stage.show(this.machine,r,this.fitted!==s.title),this.fitted=s.title,this.traced=this.marked=[]),this.drawn={scene:s,key:a}}let o=this.motion;this.motion=this.shownMotion.of(this.app),this.draw(),o!==this.motion&&this.requestUpdate()}disconnectedCallback(){super.disconnectedCallback(),this.watcher?.disconnect(),this.stage?.dispose()}screw(){let{asker:t,display:{shown:n,damped:s},state:{selection:r}}=this.app,o=t.result("modes"),a=r?.kind==="body"?this.machine?.scene.bodies.find(c=>c.name===r.name):void 0,l=o&&a&&n.kind==="mode"&&!s?yb(o,n.number,a):null;return l&&a?[l,a]:[null,null]}markScrew(){let{asker:t,display:{shown:n,damped:s},state:{selection:r}}=this.app,o=[t.result("modes"),n,s,r];if(o.every((c,h)=>c===this.marked[h])&&this.marked.length)return;this.marked=o;let[a,l]=this.screw();this.machine.showScrew(a,l)}draw(){let{asker:t,display:{playing:n,phase:s,traces:r,ghost:o,share:a,damped:l,shown:c,colouring:h},state:u}=this.app,d=this.stage,f=[this.machine,n,s,r,o,a,l,c,h,u.selection,u.case],p=[this.motion,...h==="none"?[]:["verdict","check","modes"].map(x=>t.result(x))],_=(x,C)=>x.length!==C.length||x.some((b,A)=>b!==C[A]),m=_(f,this.pictured.hand),g=d.isBehind||_(p,this.pictured.numbers);this.pictured={hand:f,numbers:p},m||g&&!this.numbersMove?d.draw():g&&d.drawWhenFree(Pm)}get numbersMove(){return this.app.asker.isOld("curves")&&!this.app.asker.hasErrors}mountValues(){let{asker:t,display:{colouring:n,shown:s},state:r}=this.app,o={verdict:t.result("verdict"),check:t.result("check"),modes:t.result("modes")};return Nv(n,o,r.case,s.kind==="mode"?s.number:null)}poleLegend(){let t=this.app.asker.result("scene");return t&&ad(t).length?re`<div class="marks"><b aria-hidden="true">P</b> pole of a body</div>`:Re}legend(){let{asker:t,display:{colouring:n}}=this.app,s=aI[n],r=s&&!t.result(s)&&(s!=="verdict"||ei(this.app));return kv(n,this.mountValues(),s!==void 0&&t.isOld(s),r?t.missing(s):"")}frame(){if(!this.machine)return;let{display:t,state:n}=this.app,s=performance.now(),r=Math.min((s-this.last)/1e3,.1);this.last=s,t.playing&&this.motion&&(t.phase=(t.phase+2*Math.PI*t.speed*r)%(2*Math.PI),this.stage.drawWhenFree(this.numbersMove?Pm:Im)),this.size(),this.trace(),this.machine.highlight(n.selection),this.markScrew(),this.machine.colour(this.mountValues()),this.machine.move(this.motion,t.phase,this.scale)}size(){let{share:t}=this.app.display,n=[this.machine,this.motion,t];n.every((s,r)=>s===this.sized[r])||(this.sized=n,this.scale=this.motion?this.machine.scaleFor(this.motion,t):0)}trace(){let{traces:t,ghost:n}=this.app.display,s=[t,n,this.motion,this.scale];s.every((r,o)=>r===this.traced[o])||(this.traced=s,this.machine.showTraces(t?this.motion:null,this.scale),this.machine.showGhosts(n,this.motion,this.scale))}slider(t,n,s,r,o,a){return re`<label class="small">${t}<input type="range" min=${n} max=${s} step=${r} .value=${String(o)}
                  @input=${l=>a(Number(l.target.value))}></label>`}choose(t){let{value:n}=t.target,{display:s,asker:r}=this.app,{shown:o}=s;if(n==="frequency")"omega"in o&&s.set({shown:{kind:"frequency",omega:o.omega}});else if(n.startsWith("steady")){let{omega:a,motion:l}=Dm(r.result("steady"),s)[Number(n.split(" ")[1])];s.set({shown:{kind:"steady",omega:a,motion:l},cursor:a})}else return s.set({shown:n==="rest"?{kind:"rest"}:{kind:"mode",number:Number(n)}});r.again()}pressed(t){this.down=[t.clientX,t.clientY]}released(t){if(Math.hypot(t.clientX-this.down[0],t.clientY-this.down[1])<4){let n=this.under(t);this.app.state.select(n&&{kind:n.kind,name:n.name})}}moved(t){if(t.buttons)return;let n=this.under(t),s=n?.words??n?.name??"";s!==this.hovered&&(this.hovered=s,this.requestUpdate())}under(t){let{left:n,top:s,width:r,height:o}=t.currentTarget.getBoundingClientRect();return this.stage.pick(2*(t.clientX-n)/r-1,1-2*(t.clientY-s)/o)}savePicture(){let{state:t,display:n,asker:s}=this.app,r=s.result("scene")?.title??"",o=t.case?`case ${t.case}`:"";this.stage.drawNow();let a=this.querySelector("canvas"),l=[[r,o].filter(Boolean).join(" · "),this.label()].filter(Boolean);Zv(a,l,n.theme==="dark"?nd:td,a.width/a.clientWidth).toBlob(c=>gm("machine.png",c))}async saveVideo(){let{display:t}=this.app,{phase:n,playing:s}=t,r=1/t.speed,{motion:o}=this;this.recording=!0,t.set({playing:!1});try{let a=await Mb(this.querySelector("canvas"),r,l=>{if(this.motion!==o)throw new Error("the motion was changed meanwhile.");t.phase=2*Math.PI*l,this.stage.drawNow()});gm("machine.webm",new Blob([a],{type:"video/webm"})),t.set({notice:`machine.webm: one period in ${Om(r).count} frames.`})}catch(a){t.set({notice:`No video: ${a instanceof Error?a.message:String(a)}`})}this.recording=!1,t.set({phase:n,playing:s})}},aI={limit:"verdict",utilisation:"check",deflection:"check",compression:"check",energy:"modes"};ue.define("machine-view",Fm);var km=class extends vn{render(){let{asker:e,file:t,state:n}=this.app,s=e.problems.filter(o=>o.severity==="error"),r=e.problems.length-s.length;return t?.trouble?.kind==="away"?Re:e.trouble?re`<div class="problems error" role="alert"><p>${e.trouble}</p><button @click=${()=>e.again()}>Try again</button></div>`:e.problems.length?re`<details class="problems ${s.length?"error":"warning"}" ?open=${s.length>0}>
      <summary>${s.length?`${s.length} ${s.length===1?"error":"errors"}`:""}${s.length&&r?", ":""}${r?`${r} ${r===1?"warning":"warnings"}`:""}</summary>
      <ul>${e.problems.map((o,a)=>{let l=hg(o,n.design.text,this.app.index);return re`<li class=${o.severity}><button class="link" id=${pa(a)} ?disabled=${!(l||fa(o))||!this.closest("page-shell")} @click=${()=>this.go(l,a)}>${Ad(o,l)}</button></li>`})}</ul></details>`:Re}show(){let e=this.querySelector("details");e&&(e.open=!0),this.querySelector(".error .link, summary")?.focus()}async go(e,t){this.app.display.set({leftTab:e?"text":"sliders"}),await new Promise(requestAnimationFrame),e?document.querySelector("text-view")?.show(e):document.querySelector(`.left [aria-describedby="${pa(t)}"]`)?.focus()}};ue.define("problem-list",km);var Bm=1e3,zm=class extends vn{constructor(){super(...arguments);this.machine=null}render(){let{state:t,display:n,asker:s}=this.app;this.machine=s.result("scene")??this.machine;let r=fc(t.design,this.app.index,n.pins,t.case,this.machine);return re`<ul class="sliders">${r.map(o=>this.row(o))}</ul>
      ${r.length||!this.machine?Re:re`<p class="hint">The file has no number that a slider could move. Add [parameters], or pin a number in the model.</p>`}
      <p class="hint">${n.pins.length?Re:"More sliders: ⊕ beside a number of the model, or [parameters] in the file."}</p>`}row(t){let n=lI(t,t.value),s=t.paths.some(l=>this.app.state.design.settings.has(l.path)),r=ug(t.paths.map(l=>l.path),this.app.asker.problems),o=r>=0,a=this.app.display.pins.includes(t.name);return re`<li class=${s?"changed":""}>
      <label title=${t.paths.map(l=>l.path).join(`
`)}><span>${t.name}</span>
        <input type="range" min="0" max=${Bm} .value=${String(n)} aria-valuetext=${t.written??`${He(t.value)} ${t.unit}`}
          @input=${l=>this.move(t,l.target.value,!0)} @change=${()=>this.app.state.dropped()}></label>
      <input class="number" aria-label="${t.name}, value" aria-invalid=${o?"true":Re} aria-describedby=${o?pa(r):Re} .value=${Eb(t)}
        @change=${l=>this.type(t,l.target)}>
      ${o?re`<small class="wrong">${dg(this.app.asker.problems[r])}</small>`:Re}
      ${t.paths.some(l=>l.path.startsWith("cases."))&&!t.name.startsWith("cases.")?re`<small class="hint">of case ${this.app.state.case}</small>`:Re}
      ${a?re`<button title="Remove the slider" @click=${()=>this.app.display.set({pins:this.app.display.pins.filter(l=>l!==t.name)})}>×</button>`:Re}
    </li>`}move(t,n,s){let r=Number(n)/Bm,o=t.logarithmic?t.from*(t.to/t.from)**r:t.from+r*(t.to-t.from);this.app.state.set(Ma(t,o),s)}type(t,n){let s=Dn(n.value.replaceAll("−","-").replace(",","."));if(!s)return xc(n,this.app,Eb(t));this.app.state.set(Ma({...t,unit:s.unit||t.unit},s.value))}},Eb=({value:i,unit:e,written:t})=>t??`${He(i,5)}${e?` ${e}`:""}`;function lI({from:i,to:e,logarithmic:t},n){let s=t?Math.log(n/i)/Math.log(e/i):(n-i)/(e-i);return Math.round(Bm*Math.min(Math.max(s||0,0),1))}ue.define("slider-panel",zm);function Tb({state:i,cases:e}){return e.length>1?re`<select aria-label="Case" @change=${t=>i.chooseCase(t.target.value)}>
      ${e.map(t=>re`<option value=${t} .selected=${t===i.case}>${t||"base model"}</option>`)}</select>`:Re}var cI={met:"✓",violated:"✗",unjudged:"?",unbinding:"(✗)",none:"○",error:"!",unknown:"…"};function Ab(i){let e=wg(i);return re`<span class="pill ${e.state}" role="status">${cI[e.state]} ${e.words}${e.old?" …":""}</span>`}var kl=class extends vn{static{this.properties={...vn.properties,times:{state:!0}}}constructor(){super(),this.times=0}connectedCallback(){super.connectedCallback(),this.times++}render(){let{app:e}=this,{state:t,asker:n,project:s,display:r,engine:o}=e,a=n.result("scene")?.title||s.title||"",l=this.getRootNode();return l instanceof ShadowRoot&&(l.host.dataset.theme=r.theme),re`<header>
        <span class="title" title=${a}>${a}</span>
        ${o.isLive?Tb(e):t.case?re`<span>${t.case}</span>`:Re}
        ${Ab(e)}<span class="space"></span>
        ${o.isLive?re`<button title="Undo" aria-label="Undo" ?disabled=${!t.canUndo} @click=${()=>t.undo()}>↶</button>
          <button title="Redo" aria-label="Redo" ?disabled=${!t.canRedo} @click=${()=>t.redo()}>↷</button>`:re`<span class="note">as it was last computed</span>`}
      </header>
      <problem-list .app=${e}></problem-list>
      ${o.isLive?re`<section aria-label="Sliders"><slider-panel .app=${e}></slider-panel></section>`:Re}
      ${T0(this.times,re`<main>
        <section class="middle" aria-label="Machine"><machine-view .app=${e}></machine-view></section>
        <section class="right" aria-label="Results"><curve-chart .app=${e}></curve-chart><result-tables .app=${e}></result-tables></section>
      </main>`)}`}};ue.define("notebook-view",kl);function Cb(){let{dataset:i,classList:e}=document.body;return i.jpThemeLight!==void 0?i.jpThemeLight==="true"?"light":"dark":e.contains("vscode-light")||e.contains("vscode-high-contrast-light")?"light":e.contains("vscode-dark")||e.contains("vscode-high-contrast")||matchMedia("(prefers-color-scheme: dark)").matches?"dark":"light"}function Vm({display:i}){let e=()=>{i.theme!==Cb()&&i.set({theme:Cb()})},t=new MutationObserver(e);return t.observe(document.body,{attributes:!0,attributeFilter:["data-jp-theme-light","class"]}),e(),()=>t.disconnect()}var Rb=["shown","damped","share","speed","frequencyUnit","logarithmicFrequency","logarithmicAmplitude","decibel"];var Pb=({display:i,asker:e},t)=>{i.set(Object.fromEntries(Rb.filter(n=>n in t).map(n=>[n,t[n]]))),e.again()};function Ib(i,e,t){let{state:n,display:s,asker:r}=i,o=0,a="",l=[],c=()=>{let d=r.finished;if(!d)return;let f=Object.fromEntries(Rb.map(_=>[_,s[_]])),p=[n.revision,JSON.stringify(f),...d.results.map(_=>_.json)];p.length===l.length&&p.every((_,m)=>_===l[m])||(e.keep(f,d),l=p)},h=()=>{let{settings:d,case:f}=n.change,p=JSON.stringify([d,f]);p!==a&&(t.set("_settings",d),t.set("_case",f),t.save_changes(),a=p),clearTimeout(o),o=window.setTimeout(c,500)},u=[n.subscribe(h),s.subscribe(h),r.subscribe(h),()=>{clearTimeout(o)}];return h(),()=>{for(let d of u)d()}}var Gm="data-trivet-still",hI=globalThis,uI=()=>(hI.trivetWidgetBuild??="313432cb7b8e08b5")==="313432cb7b8e08b5";function dI({model:i,el:e}){let t=new $l(i),n=[()=>t.close()],s=!1;return t.opened().then(r=>{if(s)return;fI(r.key);let o=Lb(e,t,r);o&&n.push(Vm(o),Ib(o,t,i))},r=>{e.textContent=r instanceof Error?r.message:String(r)}),()=>{s=!0;for(let r of n)r()}}function Lb(i,e,t){if(!uI())return i.textContent="This page already has the widget of another build of Trivet. Reload the page.",null;let n=document.createElement("div"),s=n.attachShadow({mode:"open"}),r=new CSSStyleSheet;r.replaceSync(`.uplot,.uplot *,.uplot *:before,.uplot *:after{box-sizing:border-box}.uplot{font-family:system-ui,-apple-system,Segoe UI,Roboto,Helvetica Neue,Arial,Noto Sans,sans-serif,"Apple Color Emoji","Segoe UI Emoji",Segoe UI Symbol,"Noto Color Emoji";line-height:1.5;width:min-content}.u-title{text-align:center;font-size:18px;font-weight:700}.u-wrap{position:relative;user-select:none}.u-over,.u-under{position:absolute}.u-under{overflow:hidden}.uplot canvas{display:block;position:relative;width:100%;height:100%}.u-axis{position:absolute}.u-legend{font-size:14px;margin:auto;text-align:center}.u-inline{display:block}.u-inline *{display:inline-block}.u-inline tr{margin-right:16px}.u-legend th{font-weight:600}.u-legend th>*{vertical-align:middle;display:inline-block}.u-legend .u-marker{width:1em;height:1em;margin-right:4px;background-clip:padding-box!important}.u-inline.u-live th:after{content:":";vertical-align:middle}.u-inline:not(.u-live) .u-value{display:none}.u-series>*{padding:4px}.u-series th{cursor:pointer}.u-legend .u-off>*{opacity:.3}.u-select{background:#00000012;position:absolute;pointer-events:none}.u-cursor-x,.u-cursor-y{position:absolute;left:0;top:0;pointer-events:none;will-change:transform}.u-hz .u-cursor-x,.u-vt .u-cursor-y{height:100%;border-right:1px dashed #607D8B}.u-hz .u-cursor-y,.u-vt .u-cursor-x{width:100%;border-bottom:1px dashed #607D8B}.u-cursor-pt{position:absolute;top:0;left:0;border-radius:50%;border:0 solid;pointer-events:none;will-change:transform;background-clip:padding-box!important}.u-axis.u-off,.u-select.u-off,.u-cursor-x.u-off,.u-cursor-y.u-off,.u-cursor-pt.u-off{display:none}:root,:host{color-scheme:light;--back: #ffffff;--panel: #f4f6f8;--line: #d3dae0;--text: #1d2a33;--soft: #50616c;--accent: #00659c;--accent-text: #ffffff;--good: #1c6b2f;--good-back: #dff2e3;--bad: #a81313;--bad-back: #fde4e1;--warn: #7a4b00;--warn-back: #fff0d6;--chosen: #dcebf5}:root[data-theme=dark],:host([data-theme="dark"]){color-scheme:dark;--back: #14191d;--panel: #1b2227;--line: #38444d;--text: #e3ebf0;--soft: #a3b3be;--accent: #7cc7f2;--accent-text: #0c1216;--good: #8fe0a3;--good-back: #17361f;--bad: #ffa79a;--bad-back: #451c18;--warn: #ffc56b;--warn-back: #3d2e12;--chosen: #23404f}*{box-sizing:border-box}html,body{height:100%;margin:0}body,notebook-view{background:var(--back);color:var(--text);font:13px/1.35 system-ui,DejaVu Sans,sans-serif}body{overflow:hidden}page-shell{display:flex;flex-direction:column;height:100%}h1,h2{font-size:13px;font-weight:650;margin:0}button,select,input{font:inherit;color:inherit}button,select{background:var(--back);border:1px solid var(--line);border-radius:4px;padding:2px 8px;min-height:26px}button{cursor:pointer}button:hover:not(:disabled){border-color:var(--accent)}button:disabled{opacity:.45;cursor:default}button.link{background:none;border:0;padding:0;min-height:0;text-align:left}button.link:hover:not(:disabled){text-decoration:underline}button.link:disabled{opacity:1}:focus-visible{outline:2px solid var(--accent);outline-offset:1px}input[type=range]{accent-color:var(--accent)}input[type=checkbox]{accent-color:var(--accent);margin:0;vertical-align:-2px}.hidden{position:absolute;width:1px;height:1px;overflow:hidden;clip-path:inset(50%);white-space:nowrap;margin:0}.space{flex:1}.old{color:var(--warn);font-weight:700}.hint{color:var(--soft);margin:6px 0}.missing{position:absolute;inset:40% 10% auto;text-align:center;color:var(--soft);white-space:pre-line}.outdated canvas{opacity:.35;filter:grayscale(.8)}.outdated .limits{visibility:hidden}.outdated table :is(tr,th,td,.bad,.minor){color:var(--soft)}.outdated-note{position:absolute;top:30px;left:50%;transform:translate(-50%);z-index:4;margin:0;padding:2px 10px;border:1px solid currentColor;border-radius:4px;background:var(--warn-back);color:var(--warn);font-weight:650;white-space:nowrap;pointer-events:none}.plots>.outdated-note{top:auto;bottom:31%}.table>.outdated-note{position:static;transform:none;display:inline-block;margin:4px 0}.fatal{margin:20vh auto;max-width:36em;font-size:16px}header{display:flex;align-items:center;gap:8px;padding:5px 10px;border-bottom:1px solid var(--line);min-height:40px}header button{white-space:nowrap}header h1{color:var(--accent);font-size:15px}header .title{font-weight:600;overflow:hidden;text-overflow:ellipsis;white-space:nowrap;max-width:30em;min-width:5em;flex-shrink:50}.pill{border-radius:12px;padding:3px 12px;font-weight:650;white-space:nowrap;background:var(--panel)}.pill.met{background:var(--good-back);color:var(--good)}.pill.violated,.pill.error{background:var(--bad-back);color:var(--bad)}.pill.unbinding,.pill.unjudged{background:var(--warn-back);color:var(--warn)}.pill.none,.pill.unknown{color:var(--soft)}yield-pill{display:flex;flex:0 1 auto;min-width:0}.pill.yield{overflow:hidden;text-overflow:ellipsis}.pill.yield .interval{font-weight:400;font-variant-numeric:tabular-nums}case-bar,case-bar form{display:flex;gap:4px;flex:none}progress-line{min-width:0;overflow:hidden;text-overflow:ellipsis;white-space:nowrap;color:var(--soft)}.unsaved{background:var(--accent);color:var(--accent-text);border-color:var(--accent)}.problems{padding:4px 10px;border-bottom:1px solid var(--line);max-height:30vh;overflow:auto}.problems p{margin:4px 0}.problems ul{margin:4px 0;padding-left:18px}.problems.error,.problems .error{color:var(--bad)}.problems.warning,.problems .warning{color:var(--warn)}.toast{position:fixed;bottom:12px;left:50%;transform:translate(-50%);background:var(--text);color:var(--back);padding:6px 14px;border-radius:5px;margin:0;z-index:20}.toast[hidden]{display:none}main{flex:1;min-height:0;display:grid;grid-template-columns:262px minmax(320px,1fr) minmax(400px,36%)}main.tab-text{grid-template-columns:minmax(380px,34%) minmax(300px,1fr) minmax(380px,33%)}main>section{min-width:0;min-height:0;display:flex;flex-direction:column}main>section+section{border-left:1px solid var(--line)}.scroll{overflow:auto;min-height:0}.tabs{display:flex;gap:2px;padding:5px 8px 0;border-bottom:1px solid var(--line);flex:none}.tabs button{border-radius:4px 4px 0 0;border-color:transparent;border-bottom:0;color:var(--soft);background:none}.tabs button[aria-selected=true]{color:var(--text);border-color:var(--line);background:var(--panel);font-weight:650}.panel{flex:1;padding:8px;background:var(--panel)}.tab-text .panel{padding:0}text-view{display:block;height:100%}.sliders{list-style:none;margin:0;padding:0}.sliders li{display:grid;grid-template-columns:1fr auto auto;gap:0 6px;padding:5px 0 7px;align-items:end}.sliders label{grid-column:1 / -1;display:flex;flex-direction:column}.sliders label span{padding-right:104px;overflow-wrap:anywhere;min-height:22px}.sliders li{position:relative}.sliders .number{position:absolute;top:2px;right:0;width:98px;text-align:right}.sliders button{position:absolute;top:2px;right:102px;min-height:22px;padding:0 6px}.sliders .changed span{font-weight:650;color:var(--accent)}.sliders input[type=range]{width:100%;margin:5px 0 0;height:18px}.number{background:var(--back);border:1px solid var(--line);border-radius:3px;padding:1px 5px;min-width:0;font-variant-numeric:tabular-nums}.sliders .wrong{grid-column:1 / -1;color:var(--bad);overflow-wrap:anywhere}.toast .link{color:inherit;text-decoration:underline}.number.changed{border-color:var(--accent);font-weight:650}.number[aria-invalid=true],.number.changed[aria-invalid=true]{border:2px solid var(--bad)}.tree,.tree ul{list-style:none;margin:0;padding:0}.tree ul{padding-left:13px}.tree li:not(:has(>details)){display:flex;flex-wrap:wrap;gap:1px 6px;align-items:center;padding:1px 0}.tree .key{flex:none;color:var(--soft);max-width:11em;overflow:hidden;text-overflow:ellipsis;white-space:nowrap}.tree .value{overflow:hidden;text-overflow:ellipsis;white-space:nowrap}.tree .number{flex:0 0 auto;max-width:100%;field-sizing:content;min-width:3.4em}.tree .vector{display:flex;flex-wrap:wrap;gap:2px 3px;min-width:0}.tree .pin{border:0;background:none;padding:0 2px;min-height:20px;color:var(--accent)}.tree summary{cursor:pointer;padding:1px 3px;border-radius:3px}.tree summary.chosen{background:var(--chosen);font-weight:650}machine-view{flex:1;display:flex;flex-direction:column;min-height:0}.stage{flex:1;position:relative;min-height:120px;background:var(--panel)}.stage canvas{position:absolute;inset:0;width:100%;height:100%;touch-action:none}.caption,.hover{position:absolute;left:10px;pointer-events:none;text-shadow:0 0 4px var(--panel),0 0 4px var(--panel)}.caption{top:8px;font-weight:650;right:10px}.hover{bottom:8px;color:var(--soft)}.marks{position:absolute;right:10px;bottom:8px;color:var(--soft);pointer-events:none}.marks b{display:inline-block;width:15px;height:15px;border:1.5px solid #111;border-radius:50%;background:#fff;color:#111;font:700 10px/12px system-ui,sans-serif;text-align:center;outline:1px solid var(--panel)}.legend{position:absolute;left:10px;bottom:28px;width:196px;display:flex;flex-direction:column;gap:1px;pointer-events:none;padding:5px 8px;border-radius:4px;background:color-mix(in srgb,var(--panel) 85%,transparent);font-size:12px}.legend svg{width:100%;height:11px}.legend .ticks{display:flex;justify-content:space-between;font-variant-numeric:tabular-nums}.legend .ticks.limited{display:grid;grid-template-columns:1fr auto 14.7%}.legend .ticks.limited span:last-child{text-align:right}.bar{display:flex;align-items:center;gap:4px 7px;flex-wrap:wrap;padding:4px 8px}.bar label{white-space:nowrap}.bar .small{display:flex;align-items:center;gap:4px;flex:1 1 70px}.bar .small input{width:100%;min-width:50px}.bar>select{flex:0 1 auto;min-width:0}machine-view .bar>select{flex:1}.bar .chosen{display:flex;align-items:center;gap:4px;flex:1 1 120px;min-width:0}.bar .chosen select{flex:1;min-width:40px}.views{display:flex}.views button{border-radius:0;margin-left:-1px;padding:2px 6px}.play{width:34px}main>.right{overflow-y:auto}curve-chart{flex:1 0 60%;display:flex;flex-direction:column;position:relative}curve-chart .bar{padding-bottom:0;gap:4px 6px;font-size:12px}.plots{flex:1 0 340px;display:flex;flex-direction:column;min-height:340px;position:relative}.plots>.amplitude{flex:3;min-height:0}.plots>.phase{flex:1.2;min-height:108px}.u-over{cursor:crosshair}.u-select{background:color-mix(in srgb,var(--accent) 22%,transparent)}.u-cursor-x{display:none}curve-chart .bar select{padding:2px 3px}curve-chart .bar select[aria-label=Quantity]{max-width:122px}curve-chart .bar select[aria-label="Unit of frequency"]{width:56px}.menu{position:relative}.menu summary{cursor:pointer;border:1px solid var(--line);border-radius:4px;padding:3px 8px;list-style:none}.menu>div{position:absolute;right:0;z-index:10;display:flex;flex-direction:column;gap:4px;padding:8px;background:var(--back);border:1px solid var(--line);border-radius:4px;box-shadow:0 2px 8px #0004;max-height:240px;overflow:auto}.readings span.curve svg{width:26px}.amplitude{position:relative}.limits{position:absolute;pointer-events:none;z-index:3}.limit{position:absolute;pointer-events:auto;cursor:ns-resize;touch-action:none;border-radius:3px}.limit.fixed{cursor:help}.limit:hover:not(.fixed),.limit:focus-visible{background:color-mix(in srgb,var(--accent) 25%,transparent)}.limit span{position:absolute;font-variant-numeric:tabular-nums;padding:0 3px 0 8px;color:var(--text);background:repeating-linear-gradient(var(--stroke) 0 var(--on),transparent var(--on) var(--period)) left / 3px 100% no-repeat color-mix(in srgb,var(--back) 78%,transparent);font-size:11px;line-height:14px;white-space:nowrap}.limit span.unseen{display:none}.limit:is(:hover,:focus-visible){z-index:1}.limit:is(:hover,:focus-visible) span{display:block;background-color:var(--back)}.limit.violated span{color:var(--bad);font-weight:650}.limit.unbinding span{color:var(--warn)}.readings{display:flex;flex-wrap:wrap;gap:1px 4px;padding:2px 8px;max-height:230px;overflow:auto;flex:none;font-variant-numeric:tabular-nums;border-top:1px solid var(--line)}.readings .cursor{min-width:5.5em;font-weight:650}.readings .curve{border:0;min-height:20px;padding:0 3px;background:none}.readings .curve[aria-pressed=false]{color:var(--soft);text-decoration:line-through}.readings .curve[aria-pressed=false] svg{opacity:.55}.note{color:var(--soft)}.readings details>ul{position:absolute;left:8px;right:8px;z-index:10;margin:2px 0;padding:8px 8px 8px 24px;background:var(--back);border:1px solid var(--line);border-radius:4px;box-shadow:0 2px 8px #0004;max-height:50vh;overflow:auto}.readings svg{width:18px;height:6px;vertical-align:middle}curve-chart>.table{flex:0 0 auto;max-height:220px;border-top:1px solid var(--line)}result-tables{flex:1 1 40%;display:flex;flex-direction:column;min-height:190px;border-top:1px solid var(--line)}.table{flex:1;padding:2px 8px}table{border-collapse:collapse;width:100%;font-variant-numeric:tabular-nums}caption{text-align:left;color:var(--soft)}th,td{padding:2px 6px;text-align:right;white-space:nowrap;border-bottom:1px solid var(--line)}thead th{position:sticky;top:0;background:var(--back);color:var(--soft);font-weight:600}tbody th{font-weight:500}th:first-child,.words{text-align:left}.words{white-space:normal}tbody tr:hover,tr.chosen{background:var(--chosen)}tr.violated{color:var(--bad)}tr.unbinding,.minor{color:var(--warn)}.bad{color:var(--bad);font-weight:650}td .number{width:114px;text-align:right}.requirements :is(th,td){padding:2px 4px}.requirements{table-layout:fixed}.requirements td{white-space:normal;overflow-wrap:anywhere}.requirements .value{width:124px}.requirements .margin{width:60px}.requirements .elsewhere{width:82px}.requirements .met{width:32px}.requirements .number{display:block;margin-left:auto}tr.unjudged{color:var(--soft)}.share.coupled{text-decoration:underline dotted;cursor:help}.share{padding:2px 3px}map-panel{display:flex;flex-direction:column;min-height:100%}map-panel .bar{padding:0 0 2px}.map{position:relative;flex:1 0 200px;min-height:200px;touch-action:none;cursor:crosshair}.map canvas{position:absolute;inset:0;width:100%;height:100%}.design{position:absolute;width:16px;height:16px;margin:-8px 0 0 -8px;border:3px solid var(--accent);border-radius:50%;background:var(--back);box-shadow:0 0 0 2px var(--back);cursor:move;pointer-events:none}map-panel .hint{margin:2px 0}.rules{list-style:none;margin:0;padding:0;display:flex;flex-wrap:wrap;gap:0 10px;font-size:12px}.rules svg{width:10px;height:10px;margin-right:4px}main.empty{display:block;padding:8vh 10vw;overflow:auto;font-size:15px}main.empty h2{font-size:24px}.examples{list-style:none;padding:0;display:grid;grid-template-columns:repeat(3,1fr);gap:14px}.examples button{width:100%;height:100%;padding:18px;text-align:left;display:flex;flex-direction:column;gap:8px}.examples b{font-size:16px}.examples span{color:var(--soft)}@media(max-width:980px){body{overflow:auto}page-shell{height:auto}main,main.tab-text{grid-template-columns:1fr}main>section+section{border-left:0;border-top:1px solid var(--line)}.stage{min-height:320px}.plots{height:380px;flex:none}header{flex-wrap:wrap}header .title{max-width:100%}}@media(max-width:600px){curve-chart .menu{position:static}curve-chart .menu>div{left:8px;right:auto;max-width:calc(100% - 16px)}}main.empty{padding:4vh 8vw}main.empty form{display:grid;grid-template-columns:repeat(5,minmax(0,1fr));gap:10px 14px;align-items:end;margin:10px 0 18px;font-size:13px}main.empty form label{display:flex;flex-direction:column;gap:3px}main.empty form :is(input,select){border:1px solid var(--line);border-radius:4px;background:var(--back);padding:4px 6px;min-width:0;width:100%;box-sizing:border-box}main.empty .wrong{color:var(--bad);grid-column:1 / -1;margin:0}.problems pre{margin:4px 0;max-height:16vh;overflow:auto;color:var(--text);user-select:all}.difference .first{color:var(--bad)}.difference .second{color:var(--good)}:host{display:block;container-type:inline-size;border:1px solid var(--line);border-radius:4px;overflow:hidden}notebook-view{display:flex;flex-direction:column;text-align:left;white-space:normal}notebook-view>section{padding:4px 10px 2px;background:var(--panel);border-bottom:1px solid var(--line);max-height:190px;overflow:auto}notebook-view .sliders{display:grid;grid-template-columns:repeat(auto-fill,minmax(230px,1fr));gap:0 18px}notebook-view slider-panel .hint{display:none}notebook-view>main{height:640px;flex:none;grid-template-columns:minmax(0,1fr) minmax(0,1.05fr)}notebook-view .stage{min-height:120px}notebook-view .plots{height:auto;flex:1 0 240px;min-height:240px}notebook-view curve-chart{flex:1 1 auto}notebook-view result-tables{flex:0 0 215px}@container (max-width: 760px){notebook-view>main{height:auto;grid-template-columns:1fr}notebook-view>main>section+section{border-left:0;border-top:1px solid var(--line)}notebook-view .stage{min-height:320px}notebook-view curve-chart{flex:none}notebook-view .plots{height:380px;flex:none}}
`),s.adoptedStyleSheets=[r],n.dataset.lmSuppressShortcuts="true",n.addEventListener("keydown",l=>l.stopPropagation());let o=new kl,a=M0(e,t);return o.app=a,a.display.pins=t.sliders,a.state.open(t.text,"",t.settings,t.case),s.append(o),i.replaceChildren(n),a}function fI(i){for(let t of document.querySelectorAll(`[${Gm}="${i}"]`))t.replaceChildren();let e=document.createElement("style");e.textContent=`[${Gm}="${i}"] { display: none; }`,document.head.append(e)}async function rz(){for(let i of document.querySelectorAll(`[${Gm}][data-kept]`)){if(getComputedStyle(i).display==="none")continue;let e=JSON.parse(await pI(i.dataset.kept));delete i.dataset.kept;let t=Lb(i,new Xl(e),e.opened);t&&Pb(t,e.view),t&&Vm(t)}}async function pI(i){let e=Uint8Array.from(atob(i),t=>t.charCodeAt(0));return new Response(new Blob([e]).stream().pipeThrough(new DecompressionStream("gzip"))).text()}var oz={render:dI};export{oz as default,rz as showStills};
