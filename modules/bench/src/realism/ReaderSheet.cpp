#include "realism/ReaderSheet.h"

#include <insonate/core/Words.h>

#include <nlohmann/json.hpp>

#include <array>

namespace insonate::bench {
namespace {

/// The protocol; clips are mentioned only if the set has some.
std::vector<std::string> protocol(std::size_t images, bool hasClips) {
  std::vector<std::string> lines{
      "Some of the " + std::to_string(images) + (hasClips ? " numbered images and clips" : " numbered images") +
          " are ultrasound images of patients' necks, from several machines. The others are simulated. The numbers of "
          "both are not stated.",
      "Use the screen, the light and the distance with which you read scans. Set the zoom of the browser to 100 %.",
      ("Look at each image once, in the order of the numbers. Rate it from 1 (surely real) to 6 (surely simulated). "
       "You "
       "cannot go back."),
      "There is no time limit, but the first impression counts. The time is recorded. Breaks are allowed.",
      "Judge the image, not the examination: a poor view of a patient is real, a perfect one may be simulated.",
      ("Do not talk about the images with other readers before all have finished. Do not read a set a second time: "
       "known clues make a second reading better."),
      ("Afterwards write down what gave images away. Save the ratings and return the file. Nothing leaves this "
       "computer "
       "until you return it.")};
  if (hasClips)
    lines.insert(lines.begin() + 3, "A clip lasts 1 s and repeats. Click it, or press the space bar, to stop it.");
  return lines;
}

constexpr std::array kRatings{"surely real",      "probably real",      "rather real",
                              "rather simulated", "probably simulated", "surely simulated"};

constexpr const char* kHead = R"(<!doctype html>
<html lang="en"><head><meta charset="utf-8"><title>Reading test</title><style>
body{background:#111;color:#ddd;font:17px/1.5 sans-serif;margin:0 auto;max-width:60em;padding:1.5em}
h1{font-size:1.4em}li{margin:.4em 0}button{font:inherit;padding:.5em 1em;cursor:pointer}
label{display:block;margin:.6em 0}input,textarea{font:inherit;background:#222;color:#eee;border:1px solid #666;padding:.3em}
textarea{width:100%;height:7em}#view{text-align:center;min-height:60vh}#view img{max-width:100%;max-height:72vh}
#rate{display:flex;gap:.4em}#rate button{flex:1}.note{color:#999;font-size:.9em}section[hidden]{display:none}
</style></head><body>
)";

constexpr const char* kScreens = R"(
<label>Reader code, from the organizer: <input id="reader" size="8"></label>
<label>Profession: <input id="profession" size="30" placeholder="e.g. sonographer, anesthetist"></label>
<label>Years of experience with ultrasound: <input id="years" size="4"></label>
<p><button id="begin">Begin</button> <button id="new" hidden>New Reader</button></p></section>
<section id="reading" hidden><p id="progress"></p><div id="view"><img id="image" alt=""></div>
<p class="note">Is this image real or simulated? Click a rating, or press a key from 1 to 6.</p><div id="rate"></div></section>
<section id="end" hidden><h1>All images are rated</h1>
<label>Which features gave images away, real or simulated?<textarea id="notes"></textarea></label>
<p><button id="save">Save Ratings</button></p>
<p class="note">Return the saved file to the organizer.</p></section>
)";

constexpr const char* kScript = R"(
const $=id=>document.getElementById(id);
let done=[],shownAt=0,timer=0,playing=true;
try{done=JSON.parse(localStorage.getItem(KEY))||[];}catch(e){}
function keep(){try{localStorage.setItem(KEY,JSON.stringify(done));}catch(e){}}
function screen(id){for(const s of ['start','reading','end'])$(s).hidden=s!==id;}
function show(){
 clearInterval(timer);
 if(done.length>=ITEMS.length){screen('end');return;}
 screen('reading');
 const files=ITEMS[done.length];
 $('progress').textContent='Image '+(done.length+1)+' of '+ITEMS.length;
 const frames=files.map(f=>{const i=new Image();i.src=f;return i;});
 let at=0;playing=true;$('image').src=frames[0].src;
 if(frames.length>1)timer=setInterval(()=>{if(playing){at=(at+1)%frames.length;$('image').src=frames[at].src;}},1000/30);
 shownAt=Date.now();
}
function rate(r){if($('reading').hidden)return;
 done.push([r,Math.round((Date.now()-shownAt)/100)/10]);keep();show();}
RATINGS.forEach((name,n)=>{const b=document.createElement('button');b.textContent=(n+1)+' '+name;
 b.onclick=()=>{b.blur();rate(n+1);};$('rate').appendChild(b);});
$('image').onclick=()=>playing=!playing;
document.onkeydown=e=>{if($('reading').hidden)return;
 if(e.key>='1'&&e.key<='6'&&!e.repeat)rate(+e.key);
 if(e.key===' '){playing=!playing;e.preventDefault();}};
$('begin').onclick=show;
if(done.length){$('begin').textContent=done.length<ITEMS.length?'Continue with Image '+(done.length+1):'Show Ratings to Save';
 $('new').hidden=false;$('new').onclick=()=>{done=[];keep();show();};}
$('save').onclick=()=>{
 const line=(name,text)=>'# '+name+': '+text.replace(/[\r\n]+/g,' ')+'\n';
 let text='number,rating,seconds\n'+done.map((d,n)=>(n+1)+','+d[0]+','+d[1]+'\n').join('');
 text+=line('reader',$('reader').value)+line('profession',$('profession').value)+line('years',$('years').value)+
  line('notes',$('notes').value);
 const a=document.createElement('a');a.href=URL.createObjectURL(new Blob([text],{type:'text/csv'}));
 const code=$('reader').value.replace(/[^\w-]/g,'');
 a.download=code?'ratings-'+code+'.csv':'ratings.csv';a.click();};
)";

}  // namespace

std::string sheetHtml(const std::vector<SheetItem>& items, const std::string& key) {
  bool hasClips = false;
  nlohmann::json files = nlohmann::json::array();
  for (const SheetItem& item : items) {
    hasClips = hasClips || item.files.size() > 1;
    files.push_back(item.files);
  }
  std::string html =
      std::string(kHead) + "<section id=\"start\"><h1>Which of these ultrasound images are simulated?</h1><ol>\n";
  for (const std::string& line : protocol(items.size(), hasClips)) html += "<li>" + escapedMarkup(line) + "</li>\n";
  html += std::string("</ol>") + kScreens + "<script>\nconst ITEMS=" + files.dump() +
          ",KEY=" + nlohmann::json("insonate reading test " + key).dump() +
          ",RATINGS=" + nlohmann::json(kRatings).dump() + ";" + kScript + "</script></body></html>\n";
  return html;
}

std::string readerInstructions(std::size_t images, bool hasClips) {
  std::string text =
      "# Which of these ultrasound images are simulated?\n\nOpen sheet.html in a browser: it shows one image after "
      "another and saves the ratings. Without a browser, write the ratings into ratings.csv, and remarks below them, "
      "each after a #.\n\n";
  int number = 0;
  for (const std::string& line : protocol(images, hasClips)) text += std::to_string(++number) + ". " + line + "\n";
  text += "\nRatings:";
  for (std::size_t n = 0; n < kRatings.size(); ++n)
    text += (n ? ", " : " ") + std::to_string(n + 1) + " " + kRatings[n];
  return text + ".\n\nAll images of one sort of probe have the same scale, and all are compressed alike.\n";
}

const char* clipScript() {
  return R"(<script>
document.querySelectorAll('img[data-frames]').forEach(image=>{
 const frames=image.dataset.frames.split(' ').map(f=>{const i=new Image();i.src=f;return i;});
 let at=0,playing=true;image.onclick=()=>playing=!playing;
 setInterval(()=>{if(playing){at=(at+1)%frames.length;image.src=frames[at].src;}},1000/30);});
</script>
)";
}

}  // namespace insonate::bench
